"""Tables of the claims for the documentation, with the numbers of the registry."""

from __future__ import annotations

import re
from collections.abc import Mapping

from hophoop.article.verdicts import AGREES, NOT_READ
from hophoop.claims.claim import Claim, with_unit
from hophoop.claims.literature import registry

END = "<!-- end of claims -->"


def table(works: Mapping[str, str]) -> str:
    """Return the claims of some works as a Markdown table.

    Claims whose verdict is `NOT_READ` are left out, and our reasons where we agree.

    Parameters
    ----------
    works : mapping of str to str
        Keys of references.bib, with what was read of each work.

    Returns
    -------
    text : str
    """
    rows = ["| work | read | what it says | our number | verdict |", "| --- | --- | --- | --- | --- |"]
    for work, read in works.items():
        head = f"{{cite:t}}`{work}` | {read}"
        for claim in registry():
            if claim.work == work and claim.verdict != NOT_READ:
                rows.append(f"| {head} | {_cells(claim)} |")
                head = " | "
    return "\n".join(rows)


def _cells(claim: Claim) -> str:
    ours = f"{claim.quantity} **{with_unit(claim.ours, claim.unit)}**"
    why = "" if claim.verdict == AGREES else f" {claim.why}"
    return f"{claim.claim} | {ours}.{why} | {claim.verdict}"


def works_of(mark: str) -> dict[str, str]:
    """Return the works that the mark of a table names, with what was read of each.

    Parameters
    ----------
    mark : str
        Such as ``KEY (abstract); KEY (not)``.

    Returns
    -------
    works : dict of str to str
    """
    return dict(re.findall(r"(\w+) \(([^)]+)\)", mark))


def fill_tables(text: str) -> str:
    """Return a page with the table between its marks replaced.

    Parameters
    ----------
    text : str
        With ``<!-- claims: KEY (read); KEY (read) -->`` on one line and ``<!-- end of claims -->`` on a later one; or with none
        of them.

    Returns
    -------
    text : str
    """
    lines, out, inside = text.split("\n"), [], False
    for line in lines:
        if line == END:
            inside = False
        if not inside:
            out.append(line)
        if line.startswith("<!-- claims: ") and line.endswith(" -->"):
            inside = True
            out += ["", table(works_of(line)), ""]
    return "\n".join(out)
