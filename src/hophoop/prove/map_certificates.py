"""Certificates of gaits and chaos for the checker: boxes of θ̇, and in each the phases with brackets of their ends.

Nothing of it has to be trusted. A box that is too wide for the checker is halved.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import ROUND_CEILING, Decimal
from fractions import Fraction
from typing import Any

from hophoop.prove._flint import Undecided, arb, precision
from hophoop.prove.checker.check import checked
from hophoop.prove.checker.equations import Refused
from hophoop.prove.checker.family import Family
from hophoop.prove.checker.maps import BITS, MAP_SCHEMA, MapCheck
from hophoop.prove.proof import Enclosure, decimal_of
from hophoop.prove.return_map import Piece, ReturnMap

MOST_HALVINGS = 10
SLOPE_DIGITS, SLACK = 6, 0.01
NEAR = 1e-9  # of θ̇: the half width of the box whose phases are those of a gait
TOO_WIDE = "a box is too wide"

Boxes = list[dict[str, Any]]
Wanted = Callable[[Family], bool]


class MapCertificate:
    """The certificate of a statement on a return map that is proved; the checker is asked box by box, and in the end.

    Parameters
    ----------
    returns : ReturnMap
    """

    def __init__(self, returns: ReturnMap) -> None:
        from hophoop import __version__

        self.returns = returns
        self.common = {"schema": MAP_SCHEMA, "version": __version__, "scenario": returns.scenario.to_dict()}
        self.check = MapCheck(self.common, returns.deadline)

    def gait(self, pieces: Sequence[Piece], omega: Enclosure, multiplier: Enclosure) -> dict[str, Any]:
        """The certificate of a gait that attracts the interval of the pieces.

        Raises
        ------
        Undecided, Late
            If the checker does not get through.
        """
        low, high = pieces[0].low, pieces[-1].high
        steepest = arb(0)

        def shown(image: Family) -> bool:
            nonlocal steepest
            inside = image.over > arb(low) and image.over < arb(high) and image.by.abs_upper() < 1
            steepest = steepest.max(image.by.abs_upper()) if inside else steepest
            return bool(inside)

        boxes, words = self._boxes(pieces, shown)
        with precision(BITS):  # a little more than now, for another version of FLINT may round otherwise
            contraction = decimal_of((steepest + (1 - steepest) * SLACK).upper(), ROUND_CEILING, SLOPE_DIGITS)
        place = float(omega.middle)
        phases = self.returns.piece(place * (1 - NEAR), place * (1 + NEAR)).phases
        gait = {"omega": _texts(omega), "multiplier": _texts(multiplier), "phases": phases}
        found = {
            "claim": "gait", "interval": [low, high], "words": words, "contraction": str(contraction), "gait": gait,
            "boxes": boxes,
        }  # fmt: skip
        return self._accepted(found)

    def chaos(
        self, pieces: Sequence[Sequence[Piece]], coverings: Sequence[tuple[int, int]], entropy: Decimal
    ) -> dict[str, Any]:
        """The certificate of intervals, each in pieces, that the map takes over each other.

        Raises
        ------
        Undecided, Late
            If the checker does not get through.
        """
        parts = [self._boxes(some, lambda _: True) for some in pieces]
        found = {
            "claim": "chaos", "intervals": [[some[0].low, some[-1].high] for some in pieces],
            "words": [words for _, words in parts], "coverings": [list(one) for one in coverings], "entropy": str(entropy),
            "boxes": [boxes for boxes, _ in parts],
        }  # fmt: skip
        return self._accepted(found)

    def _boxes(self, pieces: Sequence[Piece], shown: Wanted) -> tuple[Boxes, list[str]]:
        """Boxes of which the checker can show what is wanted, and their words."""
        left = [(piece, 0) for piece in reversed(pieces)]
        boxes: Boxes = []
        words: dict[str, None] = {}
        while left:
            piece, depth = left.pop()
            ends = Fraction(piece.low), Fraction(piece.high)
            try:
                word, image = self.check.image(*ends, piece.phases)
                with precision(BITS):
                    why = "" if shown(image) else TOO_WIDE
            except Refused as reason:
                why = str(reason)
            if not why:
                boxes.append({"from": [piece.low, piece.high], "phases": piece.phases})
                words[word] = None
                continue
            if depth == MOST_HALVINGS:
                raise Undecided(f"the checker cannot show that {why}")
            middle = 0.5 * (piece.low + piece.high)
            halves = [self.returns.piece(piece.low, middle), self.returns.piece(middle, piece.high)]
            left += [(half, depth + 1) for half in reversed(halves)]
        return boxes, list(words)

    def _accepted(self, found: dict[str, Any]) -> dict[str, Any]:
        certificate = self.common | found
        verdict = checked(certificate, self.returns.deadline)
        self.returns.deadline.ask()
        if not verdict.accepted:
            raise Undecided(f"the checker cannot show that {verdict.why}")
        return certificate


def _texts(found: Enclosure) -> list[str]:
    return [str(found.middle), str(found.radius)]
