"""The tables of docs/literature, from the registry of `hophoop claims`: run it after a change of either.

python examples/claim_tables.py
"""

from __future__ import annotations

from pathlib import Path

from hophoop.claims.pages import fill_tables

PAGES = Path(__file__).parents[1] / "docs" / "literature"


def main() -> None:
    """Write the pages whose table has changed."""
    for page in sorted(PAGES.glob("*.md")):
        text = page.read_text(encoding="utf-8")
        new = fill_tables(text)
        if new != text:
            page.write_text(new, encoding="utf-8", newline="\n")
            print(page.name)


if __name__ == "__main__":
    main()
