"""The time that a proof may take: one object, passed down and asked between all steps of arithmetic."""

from __future__ import annotations

import time
from collections.abc import Callable

SLACK, SLACK_SHARE = 1.0, 0.1  # s, or of the time that was given: a proof ends so much after it at most


class Late(Exception):
    """The time is over."""

    def __str__(self) -> str:
        return "there was no time for it"


class Deadline:
    """The time to give up.

    A step of arithmetic cannot be interrupted. So none is begun that would end after the slack, were it as long as the
    longest one so far.

    Parameters
    ----------
    seconds : float, optional
        From now on; without it there is no limit [s].
    clock : callable, optional
        Returns the time [s].
    """

    def __init__(self, seconds: float | None = None, clock: Callable[[], float] = time.monotonic) -> None:
        self.limited, self.clock = seconds is not None, clock
        self.late = False
        if seconds is not None:
            self.asked = clock()
            self.end = self.asked + seconds
            self.last = self.end + max(SLACK, SLACK_SHARE * seconds)
            self.longest = 0.0

    def over(self) -> bool:
        """Return True if there is no time for another step."""
        if self.limited and not self.late:
            now = self.clock()
            self.longest = max(self.longest, now - self.asked)
            self.asked = now
            self.late = now > self.end or now + self.longest > self.last
        return self.late

    def used_up(self) -> bool:
        """Return True if the slack is over as well."""
        return self.limited and self.clock() > self.last

    def expect(self, factor: float) -> None:
        """Take steps to be so many times as long from now on."""
        if self.limited:
            self.longest *= factor

    def ask(self) -> None:
        """Raise `Late` if there is no time for another step."""
        if self.limited and self.over():
            raise Late
