"""The table of docs/literature.md, from the registry of `hophoop claims`: run it after a change of either.

python examples/claim_tables.py
"""

from __future__ import annotations

from pathlib import Path

from hophoop.claims.pages import fill_tables

PAGE = Path(__file__).parents[1] / "docs" / "literature.md"


def main() -> None:
    """Write the page if its table has changed."""
    text = PAGE.read_text(encoding="utf-8")
    new = fill_tables(text)
    if new != text:
        PAGE.write_text(new, encoding="utf-8", newline="\n")
        print(PAGE.name)


if __name__ == "__main__":
    main()
