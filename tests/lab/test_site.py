"""The lab as a folder of files: whole, relative, and nothing of others written over."""

import base64
import gzip
import json
import re

import pytest
from PIL import Image

from checkout import ROOT, text_of
from cli_tools import done
from hophoop.lab import export as site


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    """The folder and what was written into it, the second time over the first."""
    folder = tmp_path_factory.mktemp("lab")
    for _ in range(2):
        written = {path.relative_to(folder).as_posix() for path in site.export(folder)}
    return folder, written


def test_the_folder_holds_all_that_its_pages_name_and_nothing_names_another_host(exported):
    folder, written = exported
    assert {"index.html", "embed.html", "static/hophoop.wasm", "static/kernel.js", "service-worker.js"} <= written
    for name in written:
        if not name.endswith((".html", ".css", ".webmanifest")):
            continue
        text = (folder / name).read_text(encoding="utf-8")
        assert "//" not in re.sub(r"/\*.*?\*/", "", text), name
        for address in re.findall(r'(?:src|href)="([^"#]*)"', text):
            assert address == "./" or address.partition("?")[0] in written, address


def test_the_policy_allows_nothing_foreign(exported):
    page = (exported[0] / "index.html").read_text(encoding="utf-8")
    assert re.findall(r'Content-Security-Policy" content="([^"]*)"', page) == [site.POLICY]
    assert "'wasm-unsafe-eval'" in site.POLICY
    assert "'unsafe-eval'" not in site.POLICY
    assert "http" not in site.POLICY


def test_the_service_worker_keeps_every_file(exported):
    folder, written = exported
    (listed,) = re.findall(r'\[("\./".*?)\]', (folder / "service-worker.js").read_text(encoding="utf-8"))
    assert set(json.loads(f"[{listed}]")) == {"./", *written} - {"service-worker.js"}


def test_another_version_is_another_cache(monkeypatch):
    first = site.site_files()["service-worker.js"]
    usual = site.static_bytes
    monkeypatch.setattr(site, "static_bytes", lambda name: usual(name) + (b" " if name == "lab.js" else b""))
    assert site.site_files()["service-worker.js"] != first


def test_other_files_are_left_alone(tmp_path):
    (tmp_path / "thesis.tex").write_text("mine")
    assert "must be a new or an empty folder" in done("lab --export", tmp_path, status=2).output
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]
    done("lab --export", tmp_path / "thesis.tex", status=2)


PACKED = re.compile(r'(?<=<script type="application/gzip" id="packed-)(\w+)">(.*?)(?=</script>)')


def unpacked(page):
    """A page with what it holds compressed, which depends on the version of zlib, as it is."""
    return PACKED.sub(lambda found: f"{found[1]} {gzip.decompress(base64.b64decode(found[2])).hex()}", page)


def test_the_kept_file_is_that_of_the_package():
    same = unpacked(text_of("play.html")) == unpacked(site.page_file())
    assert same, "remove play.html and run `hophoop lab --export play.html`"


def test_the_file_is_small_and_names_no_other(tmp_path):
    page = site.page_file()
    assert len(page.encode()) < 1_300_000
    assert [name for name, _ in PACKED.findall(page)] == ["scripts", "words", "module", "fates"]
    bare = PACKED.sub("", page)
    assert "default-src 'none'" in bare
    assert re.findall(r'(?:src|href)="(?!data:)([^"]*)"', bare) == []
    assert "hophoop-url" not in bare


def test_a_file_takes_no_other_ones_place_and_knows_its_address(tmp_path):
    path = tmp_path / "play.HTML"
    where = "https://school.example/hoop?id=1&x=2"
    for status, said in ((0, "A double click opens it"), (2, "exists already: remove it, or give another name.")):
        found = done("lab --docs https://school.example/docs --export", path, "--url", where, status=status)
        assert said in " ".join(found.output.split())
    page = path.read_text(encoding="utf-8")
    assert '<meta name="hophoop-url" content="https://school.example/hoop?id=1&amp;x=2">' in page
    assert '<meta name="hophoop-docs" content="https://school.example/docs/">' in page


def test_it_knows_where_the_documentation_is_if_told(tmp_path):
    assert b"hophoop-docs" not in site.site_files()["index.html"]
    assert "python -m http.server" in done("lab --export", tmp_path / "lab", "--docs", 'https://example.org/"docs').output
    page = (tmp_path / "lab" / "index.html").read_text(encoding="utf-8")
    assert '<meta name="hophoop-docs" content="https://example.org/&quot;docs/">' in page
    for hostile in (" JavaScript:alert(1)", "java\tscript:alert(1)", "data:text/html,x"):
        refused = done("lab --export", tmp_path / "hostile", "--docs", hostile, status=2)
        assert "must be an address of http or https" in refused.output
        assert not (tmp_path / "hostile").exists()


def test_the_pages_for_teachers_that_it_links_are_there():
    linked = re.findall(r'"(teach/[\w-]+)\.html"', text_of("web/lab/teach/teach.ts"))
    assert len(linked) == 4
    assert [page for page in linked if not (ROOT / "docs" / f"{page}.md").is_file()] == []


def test_previews_of_links_have_a_picture(tmp_path):
    content = re.compile(r'property="og:(title|description|image)" content="([^"]+)"')
    for url, place in (
        (None, "static/preview.png"),
        ("https://hoop.example/lab/", "https://hoop.example/lab/static/preview.png"),
    ):
        done("lab --export", tmp_path, *(["--url", url] if url else []))
        found = dict(content.findall((tmp_path / "index.html").read_text(encoding="utf-8")))
        assert found["image"] == place
        assert found["title"] == "The hopping hoop"
        assert "hops" in found["description"]
    picture = tmp_path / "static" / "preview.png"
    assert picture.stat().st_size < 50_000
    assert Image.open(picture).size == (1200, 630)
