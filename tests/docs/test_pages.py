"""Pages for people: their code runs, their numbers are ours, and the navigation leads to all of them."""

import pkgutil
import re
import runpy
import sys
from pathlib import Path

import pytest

from page_tools import faults, toctree_pages

DOCS = Path(__file__).parents[2] / "docs"
# They make films, or compile more kernels.
LONG = [DOCS / f"{name}.md" for name in ("article", "films", "derivatives", "compliant", "proofs", "maps")]
PAGES = [
    pytest.param(page, id=page.relative_to(DOCS.parent).as_posix(), marks=[pytest.mark.slow] if page in LONG else [])
    for page in [DOCS.parent / "README.md", DOCS.parent / "CONTRIBUTING.md", *sorted(DOCS.rglob("*.md"))]
    if page.parent.name not in ("tables", "generated") and "gallery" not in page.parts
]


@pytest.mark.parametrize("page", PAGES)
def test_what_a_page_shows_is_so(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert faults(page.read_text(encoding="utf-8"), page.name) == []


def test_the_architecture_names_what_there_is():
    text = (DOCS / "architecture.md").read_text(encoding="utf-8")
    names = re.findall(r"`((?:scenario|simulation|kernel|precise|results)\.[\w.]+)`", text)
    assert len(names) > 25
    for name in names:
        pkgutil.resolve_name(f"hophoop.{name}")


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("```pycon\n>>> 6 * 7\n41\n```\n", "Expected:"),
        ("```python\na = 2.043\n```\n\n% says: f'{a:.2f} m/s'\nIt slips\nfrom 2.05 m/s on.\n", "2.04 m/s"),
        ("% says: 1 + 1\n% says: 1 + 2\n2 of them.\n\n3 in another paragraph.\n", "1 + 2 is 3"),
        ("% not run: no film\n```python\n1 / 0\n```\n\n```pycon\n>>> 1\n2\n```\n", "Expected:"),
        ("```console\n$ hophoop run --v0 3.1 --duration -1\n```\n", "exit status 2"),
        ("```console\n$ hophoop map --axes plane.mu=0:1:9 \\\n    --out a.zarr\n```\n", "no option --axes"),
        ("```toml\n[plane]\nfriction = 1.0\n```\n", "plane.friction"),
    ],
)
def test_a_wrong_page_is_found(text, fault, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert len(found := faults(text)) == 1
    assert fault in found[0]


def test_a_right_page_has_no_fault():
    text = "````{note}\n```pycon\n>>> a = 6\n>>> a * 7\n42\n```\n````\n\n% says: a / 5\n| ratio |\n| --- |\n| 1.2 |\n"
    assert faults(text) == []


def test_names_pass_from_block_to_block_only_downwards():
    with pytest.raises(NameError):
        faults("% says: a\n1\n\n```python\na = 1\n```\n")


def test_every_page_stands_once_in_the_navigation():
    stored = {page.relative_to(DOCS).with_suffix("").as_posix() for page in DOCS.rglob("*.md") if page.parent.name != "tables"}
    assert sorted(toctree_pages(DOCS)) == sorted(stored - {"index"} | {"gallery/index"})


def test_the_moving_picture_is_the_computed_motion(tmp_path, monkeypatch):
    number = re.compile(r"-?\d*\.\d+")
    monkeypatch.setattr(sys, "argv", ["front_page.py", str(tmp_path / "hop.svg")])
    runpy.run_path(str(DOCS.parent / "examples" / "front_page.py"))
    drawn, kept = (path.read_text(encoding="utf-8") for path in (tmp_path / "hop.svg", DOCS / "_static" / "hop.svg"))
    assert number.sub("", drawn) == number.sub("", kept)
    values = [[float(value) for value in number.findall(text)] for text in (drawn, kept)]
    assert len(values[0]) > 500
    assert values[0] == pytest.approx(values[1], abs=0.011)  # the last digit written


def test_solutions_answer_every_task():
    tasks, answers = (
        re.findall(r"^#+ (\w\d\.|Exercise \d+)", (DOCS / "teach" / name).read_text(encoding="utf-8"), re.MULTILINE)
        for name in ("worksheet.md", "solutions.md")
    )
    assert len(tasks) >= 8
    assert tasks == answers
