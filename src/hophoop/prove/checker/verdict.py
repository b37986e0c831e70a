"""The checker's verdict."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Verdict:
    """The checker's verdict on a certificate.

    Attributes
    ----------
    accepted : bool
        Whether everything that the certificate states is verified.
    why : str
        What could not be verified, as a clause; empty where all is.
    events : int
        How many events are verified [1].
    conventions : tuple of str
        The conventions of the statement, as sentences without a capital; of a gait or of chaos, what it says. Empty if it
        is refused.
    """

    accepted: bool
    why: str
    events: int
    conventions: tuple[str, ...] = ()
