"""The JavaScript: what the package carries is built from the sources beside it, which are linted and typed."""

import gzip
import hashlib
import json
import re
import shutil
import subprocess
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
WEB = ROOT / "web"
BUILT = {
    "lab.js": ROOT / "src/hophoop/lab/static/lab.js",
    "widget.js": ROOT / "src/hophoop/lab/static/widget.js",
    "stage3d.js": ROOT / "src/hophoop/lab/static/stage3d.js",
    "svg.js": ROOT / "src/hophoop/lab/static/svg.js",
    "boundaries.js": ROOT / "src/hophoop/lab/static/boundaries.js",
    "kernel.js": ROOT / "src/hophoop/lab/static/kernel.js",
    "motion_element.js": ROOT / "src/hophoop/lab/static/motion_element.js",
    "embed.js": ROOT / "src/hophoop/lab/static/embed.js",
    "service_worker.js": ROOT / "src/hophoop/lab/static/service_worker.js",
    "backdrop.js": ROOT / "src/hophoop/lab/static/backdrop.js",
    "lab.css": ROOT / "src/hophoop/lab/static/lab.css",
    "embed.css": ROOT / "src/hophoop/lab/static/embed.css",
    "scene.js": ROOT / "src/hophoop/animate/static/scene.js",
}
PAGES = ("embed.html", "index.html", "pick.html", "site.html")
# What Python writes for the page.
WRITTEN = ("../src/hophoop/lab/static/tables.json", "../src/hophoop/lab/wasm/layout.json")


def stamp():
    """As web/build.mjs computes it."""
    folders = ("kernel", "lab", "model", "pages", "scene", "site", "space", "words")
    sources = [
        path.relative_to(WEB).as_posix()
        for folder in folders
        for path in (WEB / folder).rglob("*")
        if path.suffix in (".ts", ".json", ".css")
    ]
    digest = hashlib.sha256()
    for name in ["build.mjs", *WRITTEN, *sorted(sources)]:
        digest.update(f"{name}\n".encode())
        digest.update((WEB / name).read_bytes())
    return digest.hexdigest()[:32]


@pytest.mark.parametrize("name", BUILT)
def test_what_is_built_is_as_new_as_its_sources(name):
    first = BUILT[name].read_text(encoding="utf-8").split("\n", 1)[0]
    said = re.fullmatch(r"/\* Built from web/[\w/]+\.(?:ts|css) by esbuild [\d.]+; sources (\w+) \*/", first)
    assert said, first
    assert said[1] == stamp(), f"{name} is older than its sources: run `npm install && npm run build` in web/"


@pytest.fixture(scope="module")
def node():
    """What runs one of the tools that `npm install` puts into web/."""
    if not (shutil.which("node") and (WEB / "node_modules").is_dir()):
        pytest.skip("no Node with the tools of web/ (npm install --prefix web)")

    def run(*command):
        done = subprocess.run(["node", *map(str, command)], cwd=WEB, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr

    return run


def test_the_build_gives_the_same_bytes(node, tmp_path):
    node("build.mjs", tmp_path)
    pages = {name: ROOT / "src/hophoop/lab/static" / name for name in PAGES}
    for name, path in (BUILT | pages).items():
        assert (tmp_path / name).read_bytes() == path.read_bytes(), name


def test_the_first_visit_loads_at_most_120_kilobytes_without_the_module():
    first = [BUILT[name] for name in ("lab.js", "lab.css", "kernel.js")]
    first += [ROOT / "src/hophoop/lab/static" / name for name in ("index.html", "icon.svg")]
    size = sum(len(gzip.compress(path.read_bytes(), 9)) for path in first)
    assert size < 122_000  # zlib makes it less than 120; others pack a little worse


def test_a_translation_is_beside_the_page_and_english_in_it_once():
    page = BUILT["lab.js"].read_text(encoding="utf-8").replace("\\\n", "")  # long lines are broken
    for path in (WEB / "words").glob("*.json"):
        table = json.loads(path.read_text(encoding="utf-8"))
        count = Counter(text for text in table.values() if isinstance(text, str))
        long = 16 if path.stem == "zh" else 24  # shorter ones may be anything
        plain = {text for text, times in count.items() if times == 1 and re.fullmatch(r"[\w ,.;–，。；]+", text)}
        plain = {text for text in plain if len(text) >= long}
        assert len(plain) > 10
        times = {len(re.findall(f"[\"'`]{re.escape(text)}[\"'`]", page)) for text in plain}
        assert times == {int(path.stem == "en")}
        if path.stem != "en":
            built = BUILT["lab.js"].with_name(f"words.{path.name}")
            assert json.loads(built.read_text(encoding="utf-8")) == table, "run `npm run build` in web/"


def test_the_linter_finds_nothing(node):
    node("node_modules/@biomejs/biome/bin/biome", "check", "--error-on-warnings", ".")


def test_types_hold(node):
    node("node_modules/typescript/bin/tsc", "--project", ".")


def test_pure_modules_do_what_their_tests_say(node):
    node("tests/run.mjs")


def test_no_class_of_the_page_takes_all_of_it():
    """A class names the parts that it needs, `Pick<Lab, …>`, or takes them one by one."""
    sources = {path: path.read_text(encoding="utf-8") for path in (WEB / "lab").rglob("*.ts")}
    assert len(sources) > 60
    whole = re.compile(r"constructor\([^)]*: Lab\b")
    assert [path.name for path, text in sources.items() if whole.search(text)] == []


def test_no_lock_file_names_a_registry():
    kept = subprocess.run(["git", "ls-files", "web"], cwd=ROOT, capture_output=True, text=True, check=False).stdout.split()
    assert not [name for name in kept if re.search(r"[-./]lock\b", name)]
