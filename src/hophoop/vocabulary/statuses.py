"""How motions end, one row of a table each.

A new status needs a member of the kernel's `Status`, a member of `MotionStatus` and a row of `STATUSES`.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from hophoop.vocabulary import palette
from hophoop.vocabulary.words import Word


class MotionStatus(Word):
    """How a motion ended."""

    COMPLETED = "completed"
    AT_REST = "at_rest"
    JAMMED = "jammed"
    UNDETERMINED = "undetermined"
    EVENT_LIMIT = "event_limit"


MOTION_STATUSES: Final = tuple(MotionStatus)
"""By the numbers that the kernels use for them."""


class StatusFacts(NamedTuple):
    """Facts about a status."""

    sentence: str  # empty if the motion reached its duration
    color: str  # in maps
    stopped: str = ""  # in films, if the motion has no answer beyond; the command line then exits with status 1

    @property
    def ok(self) -> bool:
        """Whether the motion reached its end."""
        return not self.stopped


STATUSES: Final[dict[str, StatusFacts]] = {
    MotionStatus.COMPLETED: StatusFacts("", palette.BLUE),
    MotionStatus.AT_REST: StatusFacts("It has come to rest.", palette.SKY),
    MotionStatus.JAMMED: StatusFacts(
        "The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.",
        palette.BLACK,
        "jammed",
    ),
    MotionStatus.UNDETERMINED: StatusFacts("The model does not determine the motion beyond.", palette.YELLOW, "no answer"),
    MotionStatus.EVENT_LIMIT: StatusFacts(
        "The limit of events (contact.max_events), or of work for one motion, was reached before the end.",
        palette.PURPLE,
        "stopped",
    ),
}
