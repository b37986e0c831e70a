"""Start the lab's server; on loopback by default."""

from __future__ import annotations

import contextlib
import socket
import sys
import threading
import webbrowser
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from hophoop._support.extras import need
from hophoop._support.stopping import forget
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

LOOPBACK = "127.0.0.1"
PORT = 8765
CONNECTIONS = 1000  # maximum of simultaneous connections; further ones are told that the server is busy


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
    ImportError
        If Starlette or Uvicorn is missing.
    """
    uvicorn = need("uvicorn", "lab")
    need("starlette", "lab")
    if not 0 <= port <= 65535:
        raise InputError.of_field("port", port, "from 0 to 65535")
    line = _listening(host, port)
    port = line.getsockname()[1]
    print("The lab is starting …", file=sys.stderr)
    shown = f"[{host}]" if ":" in host else host
    if host in ("0.0.0.0", "::"):
        shown = "localhost"
    address = f"http://{shown}:{port}/"
    opened = f"{address}?{query}" if query else address
    if browser:  # it waits until the server answers; some browsers keep the thread until they are closed
        threading.Thread(target=webbrowser.open, args=(opened,), daemon=True).start()
    print(f"The lab is at {opened} (Ctrl-C stops it).", file=sys.stderr, flush=True)
    if host == "0.0.0.0" and (own := _own_address()):
        print(f"Others in your network open http://{own}:{port}/.", file=sys.stderr, flush=True)
    from hophoop.lab.server.site import create_app

    config = uvicorn.Config(
        create_app([host, *names], backdrop),
        ws="none",
        log_level="warning",
        access_log=False,
        server_header=False,
        timeout_keep_alive=30,
        timeout_graceful_shutdown=5,
        limit_concurrency=CONNECTIONS,
    )
    with contextlib.suppress(KeyboardInterrupt):
        _server(config).run([line])
    forget()  # Ctrl-C is the normal end of a server


def _server(config: Any) -> Any:
    """Return Uvicorn's server, which first ends all requests under way when it stops: nobody waits for their answers."""
    import uvicorn

    class Server(uvicorn.Server):
        async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
            for task in list(self.server_state.tasks):
                task.cancel()
            await super().shutdown(sockets)

    return Server(config)


def _own_address() -> str | None:
    """Return this machine's address in its network; a datagram socket sends nothing to connect."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # an address for documentation
            return str(probe.getsockname()[0])
        except OSError:
            return None


def _listening(host: str, port: int) -> socket.socket:
    """Return a socket that accepts connections; they wait until the server answers."""
    try:
        return socket.create_server((host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET)
    except OSError as error:
        reason = (error.strerror or str(error)).partition(" (")[0].lower()
        message = f"port = {port} cannot be used on {host}: {reason}; 0 takes a free port."
        raise InputError(message, field="port", value=port) from None
