"""Nothing in the pages leads nowhere, and nothing is fetched from elsewhere."""

from functools import cache
from urllib.parse import unquote, urlsplit

import pytest

bs4 = pytest.importorskip("bs4", reason="the extra 'docs' is not installed")


@cache
def read(page):
    """What a page links to, what it loads, and which places it has."""
    soup = bs4.BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")
    loading = soup.find_all(["img", "script", "source", "video", "iframe", "link"])
    loaded = [tag.get(name) for tag in loading if tag.get("rel") != ["canonical"] for name in ("src", "href", "poster")]
    places = {tag.get(name) for tag in soup.find_all(True) for name in ("id", "name")}
    return [tag.get("href") for tag in soup.find_all("a")], loaded, places


def broken_links(site):
    """Links and files that are not there, and files that would be fetched from elsewhere, a sentence each."""
    found = []
    for page in sorted(site.rglob("*.html")):
        name = page.relative_to(site).as_posix()
        links, loaded, _ = read(page)
        for link in dict.fromkeys(filter(None, loaded)):
            if urlsplit(link).scheme in ("http", "https") or link.startswith("//"):
                found.append(f"{name} loads {link} from elsewhere")
        for link in dict.fromkeys(filter(None, links + loaded)):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (page.parent / unquote(parts.path)).resolve() if parts.path else page.resolve()
            target = target / "index.html" if target.is_dir() else target
            if not target.is_file():
                found.append(f"{name}: {link} is not there")
            elif parts.fragment and target.suffix == ".html" and unquote(parts.fragment) not in read(target)[2]:
                found.append(f"{name}: {link} names no place of its page")
    return found


def test_links_inside_lead_somewhere(site):
    assert broken_links(site) == []


def test_a_broken_link_is_found(tmp_path):
    (tmp_path / "a.html").write_text(
        '<p id="here"><a href="#here">a</a><a href="#gone">b</a><a href="b.html">c</a><a href="c.html#x">d</a>'
        '<a href="https://example.org">e</a><script src="https://example.org/f.js"></script><img src="g%20h.png">',
        encoding="utf-8",
    )
    (tmp_path / "c.html").write_text("<p>", encoding="utf-8")
    (tmp_path / "g h.png").write_bytes(b"")
    assert broken_links(tmp_path) == [
        "a.html loads https://example.org/f.js from elsewhere",
        "a.html: #gone names no place of its page",
        "a.html: b.html is not there",
        "a.html: c.html#x names no place of its page",
    ]
