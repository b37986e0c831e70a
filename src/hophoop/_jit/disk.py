"""Numba's files of compiled code, where the disk may be full, and files may have been cut short."""

from __future__ import annotations

import contextlib
from typing import Any

from numba.core import config
from numba.core.caching import CompileResultCacheImpl, FunctionCache, _CacheLocator


class _Place(_CacheLocator):  # type: ignore[misc]
    """A folder whose name says what code is made of, so that it does not matter where its source lies and how old that is."""

    def __init__(self) -> None:
        self._folder = config.CACHE_DIR

    def get_cache_path(self) -> str:
        return str(self._folder)

    def get_source_stamp(self) -> str:
        return ""

    def get_disambiguator(self) -> str:
        return ""

    @classmethod
    def from_function(cls, function: Any, file: str) -> _Place:
        return cls()


class _Files(CompileResultCacheImpl):  # type: ignore[misc]
    _locator_classes = (_Place,)


class DiskCache(FunctionCache):  # type: ignore[misc]
    """Code that cannot be written is not kept; code that cannot be read, as after a power failure, is made again."""

    _impl_class = _Files

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
