"""Timeouts for connections: close idle, half-open and stalled ones."""

from __future__ import annotations

import asyncio
import contextlib
import json
import socket
import sys
from typing import Any

import h11
import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from hophoop.lab.server.guard import TOO_LONG

SECONDS = 15.0  # for the head of a request
TOO_LARGE = {414: TOO_LONG, 431: "The headers of this request are too long."}


class Server(uvicorn.Server):
    """Uvicorn's server, which first cancels all requests under way when it stops: nobody waits for their answers."""

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Stop."""
        for task in list(self.server_state.tasks):
            task.cancel()
        await super().shutdown(sockets)


class Connection(H11Protocol):
    """Uvicorn's protocol with a time limit for the head of a request, which Uvicorn lacks."""

    _waiting: asyncio.TimerHandle | None = None

    def connection_made(self, transport: Any) -> None:
        """Start waiting for the first request."""
        super().connection_made(transport)
        found = transport.get_extra_info("socket")
        if found is not None:
            with contextlib.suppress(OSError):  # TCP keep-alive detects a dead peer
                found.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
        self._wait()

    def data_received(self, data: bytes) -> None:
        """Continue to wait for the same head, or stop when it is complete."""
        # uvicorn's own timeout between two requests ends with their first byte
        if self._waiting is None and (self.cycle is None or self.cycle.response_complete):
            self._wait()
        super().data_received(data)
        if self.conn.their_state is not h11.IDLE:
            self._cease()

    def send_400_response(self, msg: str) -> None:
        """Answer a request that cannot be read; one whose head is too long gets a sentence, which Uvicorn lacks."""
        error = sys.exc_info()[1]
        if not (isinstance(error, h11.RemoteProtocolError) and error.error_status_hint == 431):
            super().send_400_response(msg)
            return
        status = 431 if b"\n" in self.conn.trailing_data[0] else 414
        body = json.dumps({"detail": TOO_LARGE[status]}).encode()
        headers = [("Content-Type", "application/json"), ("Content-Length", str(len(body))), ("Connection", "close")]
        for event in (h11.Response(status_code=status, headers=headers), h11.Data(data=body), h11.EndOfMessage()):
            self.transport.write(self.conn.send(event) or b"")
        self.transport.close()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop waiting."""
        self._cease()
        super().connection_lost(exc)

    def _wait(self) -> None:
        self._waiting = self.loop.call_later(SECONDS, self._give_up)

    def _cease(self) -> None:
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None

    def _give_up(self) -> None:
        self._waiting = None
        if not self.transport.is_closing():
            self.transport.close()
