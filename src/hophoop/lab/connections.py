"""Timeouts for connections: close idle, half-open and stalled ones."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

SECONDS = 15.0  # for the head of a request


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
