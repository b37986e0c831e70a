"""Pages for people: their code runs, their numbers are ours, and the navigation leads to all of them."""

import pkgutil
import re
import runpy
import sys
from pathlib import Path

import pytest

import hophoop as hh
from page_tools import COLUMNS, faults, toctree_pages, visible, wide_lines, wrong_installs

DOCS = Path(__file__).parents[2] / "docs"
# They make films, or compile more kernels.
LONG = [DOCS / f"{name}.md" for name in ("article", "films", "derivatives", "compliant", "proofs", "maps")]
PAGES = [
    pytest.param(page, id=page.relative_to(DOCS.parent).as_posix(), marks=[pytest.mark.slow] if page in LONG else [])
    for page in [
        DOCS.parent / "README.md",
        DOCS.parent / "CONTRIBUTING.md",
        DOCS.parent / "SECURITY.md",
        *sorted(DOCS.rglob("*.md")),
    ]
    if page.parent.name not in ("tables", "generated") and "gallery" not in page.parts
]


@pytest.mark.parametrize("page", PAGES)
def test_what_a_page_shows_is_so(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert faults(page.read_text(encoding="utf-8"), page.name) == []


EVERY = {page.values[0].relative_to(DOCS.parent).as_posix(): page.values[0].read_text(encoding="utf-8") for page in PAGES}
FOLDED = [name for name, text in EVERY.items() if name.startswith("docs/learn/") and visible(text) != text]


@pytest.mark.parametrize("name", FOLDED)
def test_a_page_runs_with_its_boxes_left_folded(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert faults(visible(EVERY[name]), name) == []


def test_a_name_of_a_folded_box_is_missed():
    text = "```pycon\n>>> a = 1\n```\n\n:::{dropdown} Look\n\n```pycon\n>>> b = 2\n```\n:::\n\n```pycon\n>>> a + b\n3\n```\n"
    assert faults(text) == []
    assert "NameError" in "".join(faults(visible(text)))


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
    for path in DOCS.parent.glob("examples/gallery/**/plot_*.py"):
        code = path.read_text(encoding="utf-8").split('"""', 2)[2]  # the text before wraps
        assert [line for line in code.splitlines() if len(line) > COLUMNS] == [], path


def test_wide_lines_and_installs_that_fail_are_found():
    assert wide_lines(f"```sh\n{'a' * COLUMNS}\n{'b' * (COLUMNS + 1)}\n```\n{'c' * 200}\n") == ["b" * (COLUMNS + 1)]
    wrong = ["pip install 'hophoop[lab]'", "pip install -e '.[lab]'", 'pip install "hophoop[lab]"']
    assert wrong_installs("\n".join([*wrong, 'pip install -e ".[lab]"', "`pip install -e .`, then hophoop"])) == wrong


def test_the_architecture_names_what_there_is():
    text = EVERY["docs/architecture.md"]
    packages = {path.name for path in (DOCS.parent / "src" / "hophoop").iterdir() if path.is_dir()}
    names = [name for name in re.findall(r"`(\w+\.[\w.]*\w)`", text) if name.partition(".")[0] in packages]
    assert len(names) > 50
    for name in names:
        pkgutil.resolve_name(f"hophoop.{name}")
    files = re.findall(r"`([\w/]+/[\w.]*)`", text)
    assert len(files) > 20
    for file in files:
        assert any((DOCS.parent / root / file).exists() for root in ("", "src/hophoop", "src/hophoop/kernel")), file


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


def test_a_right_page_has_no_fault():
    text = "````{note}\n```pycon\n>>> a = 6\n>>> a * 7\n42\n```\n````\n\n% says: a / 5\n| ratio |\n| --- |\n| 1.2 |\n"
    assert faults(text) == []


def test_names_pass_from_block_to_block_only_downwards():
    with pytest.raises(NameError):
        faults("% says: a\n1\n\n```python\na = 1\n```\n")


def test_every_page_stands_once_in_the_navigation():
    stored = {page.relative_to(DOCS).with_suffix("").as_posix() for page in DOCS.rglob("*.md") if page.parent.name != "tables"}
    assert sorted(toctree_pages(DOCS)) == sorted(stored - {"index"} | {"gallery/index"})


def test_the_sidebar_is_short():
    """Entries that show when no part is unfolded; the others are one click further."""
    text = EVERY["docs/index.md"]
    blocks = re.findall(r"^```\{toctree\}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    entries = [line for block in blocks for line in block.splitlines() if line and not line.startswith(":")]
    assert 20 < len(entries) <= 30


@pytest.mark.parametrize("page", ["README.md", "docs/index.md", "docs/learn/why.md"])
def test_the_story_that_it_comes_from_is_linked(page):
    text = EVERY[page]
    assert "Stand-up Maths" in text
    assert "https://www.youtube.com/watch?v=ETRpkp03stQ" in text
    assert "The physics of a hopping hoop" in text
    assert "https://www.comsol.com/blogs/the-physics-of-a-hopping-hoop" in text


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
        re.findall(r"^#+ (\w\d\.|Exercise \d+)", EVERY[f"docs/teach/{name}"], re.MULTILINE)
        for name in ("worksheet.md", "solutions.md")
    )
    assert len(tasks) >= 8
    assert tasks == answers
