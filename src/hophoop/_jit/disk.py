"""Numba's files of compiled code, where the disk may be full, and files may have been cut short."""

from __future__ import annotations

import contextlib
from typing import Any

from numba.core.caching import FunctionCache


class DiskCache(FunctionCache):  # type: ignore[misc]
    """Code that cannot be written is not kept; code that cannot be read, as after a power failure, is made again."""

    complete = True
    """Whether all code is on disk."""

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        """What is on disk for such arguments, or None."""
        try:
            return super().load_overload(signature, target_context)
        except Exception:  # what reading arbitrary bytes may raise
            with contextlib.suppress(OSError):
                self.flush()
            return None

    def save_overload(self, signature: Any, data: Any) -> None:
        """Write to disk."""
        try:
            super().save_overload(signature, data)
        except OSError:
            self.complete = False
