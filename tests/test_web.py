"""The JavaScript: what the package carries is built from the sources beside it."""

import gzip
import re
import subprocess

from checkout import ROOT
from web_tools import WEB, needs_node

LAB = ROOT / "src/hophoop/lab"
STATIC = LAB / "static"
WRITTEN = {"icon.svg", "licences.txt", "preview.png", "tables.json"}  # by hand and by Python, not by the build


def node(*command):
    """Run one of the tools that `npm install` puts into web/."""
    done = subprocess.run(["node", *map(str, command)], cwd=WEB, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@needs_node
def test_the_build_gives_the_same_bytes(tmp_path):
    node("build.mjs", tmp_path)
    (tmp_path / "film").mkdir()
    (tmp_path / "scene.js").rename(tmp_path / "film" / "scene.js")
    for built, kept in ((tmp_path, STATIC), (tmp_path / "film", ROOT / "src/hophoop/animate/static")):
        for path in built.glob("*.*"):
            assert path.read_bytes() == (kept / path.name).read_bytes(), f"{path.name}: run `npm run build` in web/"
    assert {path.name for path in STATIC.iterdir()} - WRITTEN == {path.name for path in tmp_path.glob("*.*")}


def imported(name):
    """The scripts that come with one."""
    names = re.findall(r'(?:from|[;}\n]import)"\./([^"]+)"', STATIC.joinpath(name).read_text(encoding="utf-8"))
    return {name}.union(*(imported(other) for other in names))


def test_the_first_visit_loads_at_most_109_kilobytes_without_the_module():
    first = {"index.html", "icon.svg", "lab.css"} | imported("lab.js") | imported("kernel.js")
    assert len(first) > 5
    assert sum(len(gzip.compress((STATIC / name).read_bytes(), 9)) for name in first) < 108_570
    page = (STATIC / "index.html").read_text(encoding="utf-8")
    assert set(re.findall(r'modulepreload" href="static/([^"]+)"', page)) == imported("lab.js") - {"lab.js"}


def test_the_picture_in_space_comes_without_the_words():
    (path,) = STATIC.glob("stage3d-*.js")
    assert len(gzip.compress(path.read_bytes(), 9)) < 6500
    assert "lab.js" not in imported(path.name)


@needs_node
def test_pure_modules_do_what_their_tests_say():
    node("tests/run.mjs")


def test_no_lock_file_names_a_registry():
    kept = subprocess.run(["git", "ls-files", "web"], cwd=ROOT, capture_output=True, text=True, check=False).stdout.split()
    assert not [name for name in kept if re.search(r"[-./]lock\b", name)]
