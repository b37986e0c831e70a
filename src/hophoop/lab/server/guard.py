"""Access to the lab: requests must use one of its names and come from its own page. Also HEAD, and security headers."""

from __future__ import annotations

import ipaddress
import socket
from collections.abc import Iterable
from typing import Any

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import JSONResponse

from hophoop.lab.server.page import SECURITY_HEADERS

LONGEST = 16_384  # bytes of an address
TOO_LONG = "The address of this request is too long; send the scenario in the body of a POST request."
HEAD = "hophoop.head"  # set in the scope of a HEAD request


def host_name(header: str) -> str:
    """Return the name in a Host header, without its port.

    Parameters
    ----------
    header : str
        For example ``localhost:8765`` or ``[::1]:8765``.

    Returns
    -------
    name : str
        In lower case; empty if the header is invalid.
    """
    name = header.strip().lower()
    if name.startswith("["):
        return name[1:].partition("]")[0]
    return name.partition(":")[0] if name.count(":") <= 1 else ""


def takes_gzip(header: str) -> bool:
    """Return True if a client accepts a compressed answer.

    Parameters
    ----------
    header : str
        Its Accept-Encoding.

    Returns
    -------
    takes : bool
    """
    for part in header.split(","):
        name, _, quality = part.partition(";")
        if name.strip().lower() == "gzip":
            return quality.replace(" ", "") not in ("q=0", "q=0.0", "q=0.00", "q=0.000")
    return False


class Guard:
    """Middleware that refuses requests under foreign names and from foreign pages.

    A page on another site can make a browser send requests to this machine: under its own name, which it lets resolve to this
    machine (DNS rebinding), or by a form. Addresses cannot be rebound; other names must be known. Starlette's
    TrustedHostMiddleware cannot do this: it has patterns of names, but none for any address.

    Parameters
    ----------
    app : ASGI application
    names : iterable of str
        Names under which the lab is reached, besides addresses, localhost and this machine's own.
    """

    def __init__(self, app: Any, names: Iterable[str] = ()) -> None:
        self.app = app
        self.names = {"localhost", socket.gethostname().lower(), *(name.lower() for name in names)}

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        """Pass a request on if it is allowed."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        if scope["method"] == "HEAD":
            scope = {**scope, "method": "GET", HEAD: True}
            send = _without_body(send)
        if "gzip" in headers.get("accept-encoding", "") and not takes_gzip(headers["accept-encoding"]):
            # Starlette's compression reads no qualities
            scope = {**scope, "headers": [pair for pair in scope["headers"] if pair[0] != b"accept-encoding"]}
        send = _with(send, SECURITY_HEADERS)
        if len(scope.get("raw_path", b"")) + len(scope["query_string"]) > LONGEST:
            await JSONResponse({"detail": TOO_LONG}, 414)(scope, receive, send)
            return
        refusal = self.refusal(headers, scope["path"])
        if refusal:
            await JSONResponse({"detail": refusal}, 403)(scope, receive, send)
            return
        await self.app(scope, receive, send)

    def refusal(self, headers: Headers, path: str) -> str:
        """Return why a request is refused, or ''. Pages and scripts are public; calls must come from the lab's own page."""
        host = headers.get("host", "")
        if not self._known(host_name(host)):
            return f"Host = {host[:80]!r} is not a name of this lab; `hophoop lab --name` says under which it is reached."
        if not path.startswith(("/api/", "/lab/")):
            return ""
        origin = headers.get("origin")
        foreign = headers.get("sec-fetch-site") in ("cross-site", "same-site") and headers.get("sec-fetch-mode") != "navigate"
        if foreign or (origin is not None and origin.partition("://")[2].lower() != host.strip().lower()):
            return f"Origin = {(origin or 'another site')[:80]!r} must be the lab's own page."
        return ""

    def _known(self, name: str) -> bool:
        if name in self.names or name.endswith(".localhost"):
            return True
        try:
            ipaddress.ip_address(name)
        except ValueError:
            return False
        return True


def _with(send: Any, headers: dict[str, str]) -> Any:
    async def sent(message: Any) -> None:
        if message["type"] == "http.response.start":
            MutableHeaders(scope=message).update(headers)
        await send(message)

    return sent


def _without_body(send: Any) -> Any:
    async def sent(message: Any) -> None:
        if message["type"] == "http.response.body":
            message = {**message, "body": b""}
        await send(message)

    return sent
