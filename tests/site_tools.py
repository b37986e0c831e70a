"""Links of built pages: every one that stays inside must lead to a page, a file or a place that is there."""

from collections.abc import Iterable
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class _Page(HTMLParser):
    """What a page refers to and which places it has."""

    def __init__(self) -> None:
        super().__init__()
        self.links: list[str] = []
        self.places: set[str] = set()
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.places |= {value for name in ("id", "name") if (value := given.get(name))}
        if tag == "a" and given.get("href"):
            self.links.append(given["href"] or "")
        if tag in ("img", "script", "source", "video", "iframe", "link") and given.get("rel") not in ("canonical",):
            self.loaded += [value for name in ("src", "href", "poster") if (value := given.get(name))]


@cache
def read(page: Path) -> _Page:
    """A page, parsed."""
    parsed = _Page()
    parsed.feed(page.read_text(encoding="utf-8"))
    return parsed


def broken_links(site: Path, pages: Iterable[Path] | None = None) -> list[str]:
    """Links and files that are not there, and files that would be fetched from elsewhere, a sentence each."""
    found = []
    for page in sorted(site.rglob("*.html")) if pages is None else pages:
        name = page.relative_to(site).as_posix()
        parsed = read(page)
        for link in dict.fromkeys(parsed.loaded):
            if urlsplit(link).scheme in ("http", "https") or link.startswith("//"):
                found.append(f"{name} loads {link} from elsewhere")
        for link in dict.fromkeys(parsed.links + parsed.loaded):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (page.parent / unquote(parts.path)).resolve() if parts.path else page.resolve()
            target = target / "index.html" if target.is_dir() else target
            if not target.is_file():
                found.append(f"{name}: {link} is not there")
            elif parts.fragment and target.suffix == ".html" and unquote(parts.fragment) not in read(target).places:
                found.append(f"{name}: {link} names no place of its page")
    return found
