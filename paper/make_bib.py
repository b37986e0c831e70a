"""The works that paper.md cites, from docs/references.bib: python paper/make_bib.py"""

from __future__ import annotations

import re
from pathlib import Path

from hophoop.cite import references

HERE = Path(__file__).parent


def bibliography() -> str:
    """The entries of all keys in paper.md, in the order of references.bib."""
    cited = set(re.findall(r"@(\w+)", (HERE / "paper.md").read_text(encoding="utf-8").split("---", 2)[2]))
    missing = cited - set(references())
    if missing:
        raise SystemExit(f"docs/references.bib has no {', '.join(sorted(missing))}.")
    return "\n\n".join(work.bibtex for key, work in references().items() if key in cited) + "\n"


if __name__ == "__main__":
    (HERE / "paper.bib").write_text(bibliography(), encoding="utf-8", newline="\n")
