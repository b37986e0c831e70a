"""What to cite for a motion: the works that its laws and the phenomena in it rest on."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import hophoop
from hophoop.kernel.physics import ImpactLaw
from hophoop.scenario import Compliant, InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.names import LAWS

__all__ = ["cite", "bibtex", "references", "Reference"]

_ACCENTS = {"'": "\u0301", "`": "\u0300", '"': "\u0308", "^": "\u0302", "~": "\u0303"}


@dataclass(frozen=True)
class Reference:
    """A work, and why a motion rests on it.

    Attributes
    ----------
    key : str
        Of the entry in references.bib.
    kind : str
        Of the entry: article, book, software, ...
    fields : dict of str to str
        Its fields as BibTeX has them.
    reason : str
        What in the motion the work is cited for; empty in `references`.
    """

    key: str
    kind: str
    fields: dict[str, str] = field(hash=False)
    reason: str = ""

    def __str__(self) -> str:
        """The work in one line, for people."""
        said = {name: _plain(value) for name, value in self.fields.items()}
        authors = " and ".join(_natural(name) for name in said.get("author", "").split(" and "))
        where = said.get("journal") or said.get("publisher") or said.get("howpublished") or said.get("note", "")
        if "volume" in said:
            where += f" {said['volume']}"
        if "pages" in said:
            where += f", {said['pages']}"
        return f"{authors} ({said.get('year', 'n.d.')}). {said['title']}. {where}".rstrip() + "."

    @property
    def bibtex(self) -> str:
        """The entry as BibTeX."""
        lines = [f"  {name} = {{{value}}}," for name, value in self.fields.items()]
        return "\n".join([f"@{self.kind}{{{self.key},", *lines, "}"])


def references() -> dict[str, Reference]:
    """All works that hophoop knows of.

    Returns
    -------
    references : dict of str to Reference
        By key, in the order of references.bib.

    Examples
    --------
    >>> print(references()["Tokieda1997"])
    Tadashi F. Tokieda (1997). The hopping hoop. The American Mathematical Monthly 104, 152–154.
    """
    return dict(_library())


def cite(motion: Trajectory) -> tuple[Reference, ...]:
    """The works that a motion rests on, each with the reason.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    references : tuple of Reference
        hophoop itself first, then by what the scenario assumes and what happened in the motion.

    Examples
    --------
    >>> import hophoop as hh
    >>> motion = hh.simulate(hh.Hoop(), hh.Plane(), hh.Start.rolling(1.0), duration=1.0)
    >>> [work.key for work in cite(motion)]
    ['hophoop', 'Theron2000']
    """
    if not hasattr(motion, "scenario"):
        raise InputError(f"motion must be a Trajectory, not {type(motion).__name__}.")
    library = _library()
    found: dict[str, Reference] = {"hophoop": _software(motion.version)}
    for key, reason in _reasons(motion):
        if key not in found:
            entry = library[key]
            found[key] = Reference(key, entry.kind, entry.fields, reason)
    return tuple(found.values())


def bibtex(motion: Trajectory) -> str:
    """The works that a motion rests on, as a BibTeX file.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    text : str
        Each entry with its reason as a comment before it.
    """
    return "\n\n".join(f"% {work.reason}\n{work.bibtex}" for work in cite(motion)) + "\n"


# --- inside ----------------------------------------------------------------------------------------


def _reasons(motion: Trajectory) -> Iterator[tuple[str, str]]:
    hoop, plane, contact = motion.scenario.hoop, motion.scenario.plane, motion.scenario.contact
    kinds = {event.kind for event in motion.events}
    modes = set(motion.sequence)
    if hoop.massless:
        yield "Littlewood1953", "the problem of the massless hoop"
        yield "Tokieda1997", "the problem as the hopping hoop"
        yield "Butler1999", "that the massless hoop does not hop"
        yield "Pritchett1999", "the problem revisited"
        yield "TheronDuPlessis2001", "how the massless hoop moves when the contact force is lost"
    elif "R" in modes:
        yield "Theron2000", "rolling of a loaded wheel"
    if isinstance(contact, Compliant):
        yield "Sonnerlind2023", "the hoop in compliant contact"
        if contact.law == "hunt-crossley":
            yield "HuntCrossley1975", "the damping of the contact force"
    elif not hoop.massless and modes & set("SKH"):
        yield "TheronMaritz2008", "spin, skid and hop of a loaded hoop"
    if "slip_start" in kinds:
        yield "BronarsOReilly2019", "slip that sets in from rolling"
    if plane.slope != 0.0:
        yield "Gomez2012", "an eccentric cylinder that jumps on a slope"
        yield "ArroyoAparicio2023", "general eccentric cylinders on a slope"
    if "impact" in kinds or "bounce_limit" in kinds:
        yield "Routh1877", "the impulse of an impact with friction"
        law = LAWS[ImpactLaw[plane.impact_law.upper()]]
        if plane.restitution > 0.0 and law.reference is not None:
            yield law.reference
    if "kane_gain" in kinds:
        yield "Kane1984", "the energy that Newton's restitution creates"
    if kinds & {"painleve_inconsistent", "painleve_indeterminate", "jam"}:
        yield "Painleve1895", "the paradox of rigid contact with friction"
        yield "ChampneysVarkonyi2016", "the paradox and what may follow it"
    if "painleve_inconsistent" in kinds:
        yield "HoganKristiansen2017", "the impact without collision"
    if "jam" in kinds:
        yield "GenotBrogliato1999", "the dynamic jam"


def _software(version: str) -> Reference:
    fields = {
        "author": "{The hophoop developers}",
        "title": "hophoop: exact motion of a loaded hoop on a plane",
        "version": version,
        "year": "2026",
        "note": f"Version {version}",
    }
    return Reference("hophoop", "software", fields, "the program that computed the motion")


def _path() -> Path:
    """references.bib: inside an installed package, in docs/ of a checkout."""
    package = Path(hophoop.__file__).parent
    installed = package / "references.bib"
    return installed if installed.exists() else package.parents[1] / "docs" / "references.bib"


@cache
def _library() -> dict[str, Reference]:
    text = re.sub(r"^\s*%.*$", "", _path().read_text(encoding="utf-8"), flags=re.MULTILINE)
    found = {}
    for match in re.finditer(r"@(\w+)\{(\w+),", text):
        body = text[match.end() : _closing(text, match.end())]
        fields = {}
        for name in re.finditer(r"(\w+)\s*=\s*\{", body):
            if body[: name.start()].count("{") == body[: name.start()].count("}"):
                fields[name[1]] = " ".join(body[name.end() : _closing(body, name.end())].split())
        found[match[2]] = Reference(match[2], match[1], fields)
    return found


def _closing(text: str, begin: int) -> int:
    """Where the brace closes that was opened just before `begin`."""
    depth = 1
    for place in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place
    raise ValueError("references.bib has a brace that is not closed.")


def _plain(value: str) -> str:
    """BibTeX text as people read it: accents composed, braces gone, dashes drawn."""
    value = re.sub(
        r"\\(['`\"^~])\{?(\w)\}?",
        lambda found: unicodedata.normalize("NFC", found[2] + _ACCENTS[found[1]]),
        value,
    )
    return re.sub(r"[{}]", "", value).replace("--", "–").replace("~", " ")


def _natural(name: str) -> str:
    """'Last, First' turned round."""
    last, comma, first = name.partition(", ")
    return f"{first} {last}" if comma else last
