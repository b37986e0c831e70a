"""Pages for people: their code runs, their numbers are ours, and the navigation leads to all of them."""

import pkgutil
import re
import runpy
import sys

import pytest

import hophoop as hh
from checkout import ROOT
from page_tools import COLUMNS, faults, visible, wide_lines, wrong_installs

DOCS = ROOT / "docs"
# They make films, or compile more kernels.
LONG = [DOCS / f"{name}.md" for name in ("article", "films", "derivatives", "compliant", "proofs", "maps")]
PAGES = [
    pytest.param(page, id=page.relative_to(ROOT).as_posix(), marks=[pytest.mark.slow] if page in LONG else [])
    for page in [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        ROOT / "SECURITY.md",
        *sorted(DOCS.rglob("*.md")),
    ]
    if page.parent.name not in ("tables", "generated") and "gallery" not in page.parts
]


@pytest.mark.parametrize("page", PAGES)
def test_what_a_page_shows_is_so(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert faults(page.read_text(encoding="utf-8"), page.name) == []


EVERY = {page.values[0].relative_to(ROOT).as_posix(): page.values[0].read_text(encoding="utf-8") for page in PAGES}
FOLDED = [name for name, text in EVERY.items() if name.startswith("docs/learn/") and visible(text) != text]


@pytest.mark.parametrize("name", FOLDED)
def test_a_page_runs_with_its_boxes_left_folded(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert faults(visible(EVERY[name]), name) == []


def test_live_motions_are_computed_to_their_end():
    """One in the first hop, and one in each box of 'Why does it hop?' that is opened after a prediction."""
    live = {name: re.findall(r"^:::\{motion\} (\S+)$", text, re.MULTILINE) for name, text in EVERY.items()}
    for query in set().union(*live.values()):
        assert hh.simulate(hh.Scenario.from_query(query)).status == "completed", query
    assert len(live["docs/learn/first-hop.md"]) == 1
    assert len(live["docs/learn/why.md"]) == EVERY["docs/learn/why.md"].count("{dropdown} Look") == 7


def test_code_is_as_wide_as_its_page_and_what_it_installs_can_be_had():
    for name, text in EVERY.items():
        assert wide_lines(text) == [], name
        assert wrong_installs(text) == [], name
        assert "pip install" not in text or re.search(r"activate|\{doc\}`[./]*install`", text), name
    for name in ("docs/install.md", "docs/learn/first-hop.md"):
        assert "source .venv/bin/activate" in EVERY[name]
        assert r".venv\Scripts\activate" in EVERY[name]
    for path in ROOT.glob("examples/gallery/**/plot_*.py"):
        code = path.read_text(encoding="utf-8").split('"""', 2)[2]  # the text before wraps
        assert [line for line in code.splitlines() if len(line) > COLUMNS] == [], path


def test_the_architecture_names_what_there_is():
    text, root = EVERY["docs/architecture.md"], ROOT / "src" / "hophoop"
    names = [name for name in re.findall(r"`(\w+\.[\w.]*\w)`", text) if (root / name.partition(".")[0]).is_dir()]
    files = re.findall(r"`([\w/]+/[\w.]*)`", text)
    assert len(names) > 50
    assert len(files) > 20
    for name in names:
        pkgutil.resolve_name(f"hophoop.{name}")
    for file in files:
        assert any((place / file).exists() for place in (ROOT, root, root / "kernel")), file


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("```pycon\n>>> 6 * 7\n41\n```\n", "Expected:"),
        ("```python\na = 2.043\n```\n\n% says: f'{a:.2f} m/s'\nIt slips\nfrom 2.05 m/s on.\n", "2.04 m/s"),
        ("% says: 1 + 1\n% says: 1 + 2\n2 of them.\n\n3 in another paragraph.\n", "1 + 2 is 3"),
        ("% not run: no film\n```python\n1 / 0\n```\n\n```pycon\n>>> 1\n2\n```\n", "Expected:"),
        ("```console\n$ hophoop run --v0 3.1 --duration -1\n```\n", "exit status 2"),
        ("```console\n$ hophoop run --v0 2 --duration 2 --quiet\nRKR\n```\n", "--quiet prints"),
        ("```console\n$ hophoop map --axes plane.mu=0:1:9 \\\n    --out a.zarr\n```\n", "no option --axes"),
        ("```toml\n[plane]\nfriction = 1.0\n```\n", "plane.friction"),
    ],
)
def test_a_wrong_page_is_found(text, fault, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert len(found := faults(text)) == 1
    assert fault in found[0]


@pytest.mark.parametrize("page", ["README.md", "docs/index.md", "docs/learn/why.md"])
def test_the_story_that_it_comes_from_is_linked(page):
    for link in ("https://www.youtube.com/watch?v=ETRpkp03stQ", "https://www.comsol.com/blogs/the-physics-of-a-hopping-hoop"):
        assert link in EVERY[page]


def test_the_moving_picture_is_the_computed_motion(tmp_path, monkeypatch):
    number = re.compile(r"-?\d*\.\d+")
    monkeypatch.setattr(sys, "argv", ["front_page.py", str(tmp_path / "hop.svg")])
    runpy.run_path(str(ROOT / "examples" / "front_page.py"))
    drawn, kept = (path.read_text(encoding="utf-8") for path in (tmp_path / "hop.svg", DOCS / "_static" / "hop.svg"))
    assert number.split(drawn) == number.split(kept)
    values = [[float(value) for value in number.findall(text)] for text in (drawn, kept)]
    assert values[0] == pytest.approx(values[1], abs=0.011)  # the last digit written


def test_solutions_answer_every_task():
    tasks, answers = (
        re.findall(r"^#+ (\w\d\.|Exercise \d+)", EVERY[f"docs/teach/{name}"], re.MULTILINE)
        for name in ("worksheet.md", "solutions.md")
    )
    assert len(tasks) >= 8
    assert tasks == answers
