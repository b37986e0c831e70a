"""Why a change of the source cannot be seen: by module, function, the line as it stands and as it is with the change."""

from __future__ import annotations

EXPLAINED: dict[tuple[str, str, str, str], str] = {}
