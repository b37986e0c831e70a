"""The lab's server: the files of the exported page, and the film of a fit under the hoop; on loopback by default.

The page computes by itself, so nothing is asked of Python but files.
"""

from __future__ import annotations

import contextlib
import gzip
import ipaddress
import json
import socket
import sys
import threading
import webbrowser
from collections.abc import Iterable, Mapping, Sequence
from functools import cache, partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import PurePath
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from hophoop._support.stopping import forget
from hophoop.lab.export import POLICY, site_files, static_bytes
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

LOOPBACK = "127.0.0.1"
PORT = 8765
SECURITY = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'self'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
}
MEDIA = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".txt": "text/plain; charset=utf-8",
    ".json": "application/json",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".ico": "image/svg+xml",
    ".mp4": "video/mp4",
    ".wasm": "application/wasm",
}
UNPACKED = ("image/png", "video/mp4")  # not compressed again
# What only an exported folder needs: a visitor's browser would keep the page without this server.
FOLDER_ONLY = ("service-worker.js", "manifest.webmanifest")
MARKS = (b'<meta name="hophoop-site" content="service-worker.js">\n', b'<link rel="manifest" href="manifest.webmanifest">\n')


def serve(
    host: str = LOOPBACK,
    port: int = PORT,
    browser: bool = False,
    query: str = "",
    names: Sequence[str] = (),
    backdrop: Backdrop | None = None,
) -> None:
    """Serve the lab until it is stopped.

    Parameters
    ----------
    host : str, default '127.0.0.1'
        Address to listen on; the default only answers this machine.
    port : int, default 8765
        Port; 0 selects a free one [1].
    browser : bool, default False
        Open the page in a browser.
    query : str, default ''
        A scenario's link that the browser opens with.
    names : sequence of str, optional
        Names under which the lab is reached; addresses and this machine's own name are
        known. Requests under any other name are refused.
    backdrop : Backdrop, optional
        A film to show under the hoop.

    Raises
    ------
    ValueError
        If the port is in use or a number is not allowed.
    """
    if not 0 <= port <= 65535:
        raise InputError.of_field("port", port, "from 0 to 65535")
    with server_of(host, port, names, backdrop) as server:
        shown = "localhost" if host in ("0.0.0.0", "::") else f"[{host}]" if ":" in host else host
        address = f"http://{shown}:{server.server_address[1]}/" + (f"?{query}" if query else "")
        if browser:  # it waits until the server answers; some browsers keep the thread until they are closed
            threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()
        print(f"The lab is at {address} (Ctrl-C stops it).", file=sys.stderr, flush=True)
        if host == "0.0.0.0" and (own := _own_address()):
            print(f"Others in your network open http://{own}:{server.server_address[1]}/.", file=sys.stderr, flush=True)
        with contextlib.suppress(KeyboardInterrupt):
            server.serve_forever()
    forget()  # Ctrl-C is the normal end of a server


def server_of(
    host: str = LOOPBACK, port: int = 0, names: Iterable[str] = (), backdrop: Backdrop | None = None
) -> ThreadingHTTPServer:
    """Return a server that accepts connections, which wait until it serves.

    Parameters
    ----------
    host, port, names, backdrop
        As in `serve`.

    Returns
    -------
    server : ThreadingHTTPServer
    """
    known = {"localhost", socket.gethostname().lower(), host, *(name.lower() for name in names)}
    server = _Server((host, port), partial(_Files, files_of(backdrop), known), bind_and_activate=False)
    server.socket.close()
    try:
        server.socket = socket.create_server((host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET)
    except OSError as error:
        reason = (error.strerror or str(error)).partition(" (")[0].lower()
        message = f"port = {port} cannot be used on {host}: {reason}; 0 takes a free port."
        raise InputError(message, field="port", value=port) from None
    server.server_address = server.socket.getsockname()
    return server


def files_of(backdrop: Backdrop | None = None) -> dict[str, bytes]:
    """Return what is served, by path.

    Parameters
    ----------
    backdrop : Backdrop, optional
        A film to show under the hoop.

    Returns
    -------
    files : dict of str to bytes
    """
    files = {name: content for name, content in site_files().items() if name not in FOLDER_ONLY}
    page = files.pop("index.html")
    for mark in MARKS:
        page = page.replace(mark, b"")
    files["favicon.ico"] = files["static/icon.svg"]
    if backdrop is not None:
        page = page.replace(b"</head>", b'<script type="module" src="backdrop.js"></script>\n</head>')
        place = json.dumps(backdrop.to_dict()).encode()
        files |= {"film.json": place, "film.mp4": backdrop.film.read_bytes(), "backdrop.js": static_bytes("backdrop.js")}
    return files | {"": page}


class _Server(ThreadingHTTPServer):
    """A server that reports no client that went away."""

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Print every other error."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


class Answer(BaseHTTPRequestHandler):
    """Whole answers with their length, after which the connection stays open."""

    protocol_version = "HTTP/1.1"
    timeout = 30.0  # after which an idle connection is closed [s]
    always: Mapping[str, str] = {}  # headers of every answer

    def send(self, kind: str, body: bytes, status: int = 200, headers: Mapping[str, str] | None = None) -> None:
        """Send an answer."""
        self.send_response(status)
        sizes = {"Content-Type": kind, "Content-Length": str(len(body))}
        for name, value in {**self.always, **(headers or {}), **sizes}.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *args: Any) -> None:
        """Log nothing."""


class _Files(Answer):
    """Files by path, for requests under one of the server's names.

    A page elsewhere may let its own name resolve to this machine (DNS rebinding); addresses cannot be rebound.
    """

    always = SECURITY

    def __init__(self, files: dict[str, bytes], known: set[str], *args: Any) -> None:
        self.files, self.known = files, known
        super().__init__(*args)

    def do_GET(self) -> None:
        """Answer with a file."""
        path = urlsplit(self.path).path.removeprefix("/")
        host = self.headers.get("Host", "")
        if not self._knows(host_name(host)):
            said = f"Host = {host[:80]!r} is not a name of this lab; `hophoop lab --name` says under which it is reached."
            self.send(MEDIA[".txt"], said.encode(), 403)
        elif path not in self.files:
            self.send(MEDIA[".txt"], b"There is no such file.", 404)
        else:
            self._send_file(MEDIA[PurePath(path or "index.html").suffix], self.files[path])

    def _send_file(self, kind: str, body: bytes) -> None:
        if kind in UNPACKED or "gzip" not in self.headers.get("Accept-Encoding", ""):
            self.send(kind, body)
        else:
            self.send(kind, _packed(body), headers={"Content-Encoding": "gzip"})

    def _knows(self, name: str) -> bool:
        if name in self.known or name.endswith(".localhost"):
            return True
        try:
            ipaddress.ip_address(name)
        except ValueError:
            return False
        return True


@cache
def _packed(body: bytes) -> bytes:
    return gzip.compress(body, 6, mtime=0)


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


def _own_address() -> str | None:
    """Return this machine's address in its network; a datagram socket sends nothing to connect."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # an address for documentation
            return str(probe.getsockname()[0])
        except OSError:
            return None
