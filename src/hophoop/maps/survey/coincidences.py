"""Coincidences of events on borders between classes of the first revolution.

On one side of a border an event happens just before another, or just happens; on the other side just after it, or just
not. The possible coincidences determine which classes can be neighbours. Neighbours that differ by more have another class
between them, however narrow.

One pair always differs by more; `hophoop.maps.survey.strips` describes the classes between.
"""

from __future__ import annotations

from functools import cache

REVERSAL, REVOLUTIONS, TAKEOFF = "reversal", "revolutions", "takeoff"
OTHER = {"S": "K", "K": "S"}

Class = tuple[str, str]


@cache
def coincidence(one: Class, other: Class) -> str:
    """Return the name of the coincidence on a border between two classes.

    Parameters
    ----------
    one, other : tuple of str
        Sequence and ending.

    Returns
    -------
    name : str
        '' if they differ by more than one coincidence, otherwise one of

        * ``start``: gravity just holds the rim down at the start;
        * ``cone``: rolling just touches the edge of the friction cone, within the phase or as slip ends;
        * ``mirror``: rolling just touches the cone at mirror angles before and after the bottom, with opposite friction:
          the loss at the first contact does not prevent the second;
        * ``graze``: slip comes to zero as its rate does;
        * ``lift``: the normal force of slip just comes to zero;
        * ``end``: the last event coincides with the end;
        * ``top``: the hoop comes to rest just at the top, rolling or spinning.
    """
    (short, end), (long, other_end) = sorted((one, other), key=lambda item: len(item[0]))
    if "H" in (short, long):
        return "start"
    if end == other_end and long in _grown(short):
        return _grown(short)[long]
    if end == other_end != TAKEOFF and len(long) == len(short) + 1 and long.startswith(short):
        return "end"
    for (sequence, ends), (neighbour, _) in (((short, end), (long, other_end)), ((long, other_end), (short, end))):
        if ends == TAKEOFF and neighbour.startswith(sequence[:-1]):
            return "lift"
    if short == long and {end, other_end} == {REVERSAL, REVOLUTIONS} and short[-1] in "RS":
        return "top"
    return ""


def _grown(sequence: str) -> dict[str, str]:
    """Return the sequences with one more phase inside, and the coincidence at which it appears."""
    found: dict[str, str] = {}
    for i, mode in enumerate(sequence):
        after = sequence[i + 1 : i + 2]
        head, tail = sequence[: i + 1], sequence[i + 1 :]
        if mode == "R":
            for slip in OTHER:
                found.setdefault(f"{head}{slip}R{tail}", "cone")
                found.setdefault(f"{head}{slip}R{OTHER[slip]}R{tail}", "mirror")
        elif mode in OTHER:
            found.setdefault(f"{head}R{mode}{tail}", "graze")
            if after == OTHER[mode]:
                found.setdefault(f"{head}R{tail}", "cone")
            elif after == "R":
                found.setdefault(f"{head}{OTHER[mode]}{tail}", "cone")
    return found
