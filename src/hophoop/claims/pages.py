"""Tables of the claims for the documentation, with the numbers of the registry."""

from __future__ import annotations

from collections.abc import Iterable

from hophoop.article.verdicts import AGREES
from hophoop.claims.claim import Claim, with_unit
from hophoop.claims.literature import registry

END = "<!-- end of claims -->"


def table(works: Iterable[str]) -> str:
    """Return the claims of some works as a Markdown table.

    Parameters
    ----------
    works : iterable of str
        Keys of references.bib.

    Returns
    -------
    text : str
    """
    wanted = tuple(works)
    rows = ["| what it says | theirs | our number | verdict |", "| --- | --- | --- | --- |"]
    rows += [_row(claim) for work in wanted for claim in registry() if claim.work == work]
    return "\n".join(rows)


def _row(claim: Claim) -> str:
    ours = f"{claim.quantity} **{with_unit(claim.ours, claim.unit)}**"
    why = "" if claim.verdict == AGREES else f" {claim.why}"
    return f"| {claim.claim} | {claim.theirs} | {ours}.{why} | {claim.verdict} |"


def fill_tables(text: str) -> str:
    """Return a page with the table between its marks replaced.

    Parameters
    ----------
    text : str
        With ``<!-- claims: KEY KEY -->`` on one line and ``<!-- end of claims -->`` on a later one; or with none of them.

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
            out += ["", table(line.removeprefix("<!-- claims: ").removesuffix(" -->").split()), ""]
    return "\n".join(out)
