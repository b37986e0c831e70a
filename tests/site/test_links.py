"""Nothing in the pages leads nowhere, and nothing is fetched from elsewhere."""

from functools import cache
from urllib.parse import unquote, urlsplit

import pytest

bs4 = pytest.importorskip("bs4")


@cache
def read(page):
    """What a page links to, what it loads, and which places it has."""
    soup = bs4.BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")
    loading = soup.find_all(["img", "script", "source", "video", "iframe", "link"])
    loaded = [tag.get(name) for tag in loading if tag.get("rel") != ["canonical"] for name in ("src", "href", "poster")]
    places = {tag.get(name) for tag in soup.find_all(True) for name in ("id", "name")}
    links = [tag.get("href") for tag in soup.find_all("a")]
    return [link for link in links if link], [link for link in loaded if link], places


def broken_links(site):
    """Links and files that are not there, and files that would be fetched from elsewhere."""
    found = set()
    for page in site.rglob("*.html"):
        links, loaded, _ = read(page)
        for link in links + loaded:
            parts = urlsplit(link)
            wrong = link in loaded and (parts.scheme in ("http", "https") or link.startswith("//"))
            if not parts.scheme and not parts.netloc:
                target = (page.parent / unquote(parts.path)).resolve() if parts.path else page.resolve()
                target = target / "index.html" if target.is_dir() else target
                lacks = parts.fragment and target.suffix == ".html" and unquote(parts.fragment) not in read(target)[2]
                wrong = not target.is_file() or lacks
            if wrong:
                found.add((page.relative_to(site).as_posix(), link))
    return sorted(found)


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
    wrong = ["#gone", "b.html", "c.html#x", "https://example.org/f.js"]
    assert broken_links(tmp_path) == [("a.html", link) for link in wrong]
