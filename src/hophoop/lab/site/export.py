"""The lab as a folder of static files, which any web host can serve: the visitor's browser computes."""

from __future__ import annotations

import gzip
import hashlib
import html
import json
import re
from functools import cache
from importlib.resources import files
from pathlib import Path

from hophoop._support.files import replacing
from hophoop._version import __version__
from hophoop.lab.wasm.stamp import DERIVATIVES, MODULE, built
from hophoop.scenario import InputError

# Nothing may be loaded from or sent to other sites. Browsers accept frame-ancestors only as a header, not from the page.
POLICY = (
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; img-src 'self' data: blob:; "
    "media-src 'self' blob:; style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'none'; form-action 'none'"
)
# Files of static/ that are not for visitors: other pages, and what Python fills or the notebook widget starts with.
OWN = ("backdrop.js", "pick.html", "service-worker.js", "tables.json", "widget.js")
_STATIC = files("hophoop.lab") / "static"
_WORDS = files("hophoop.lab") / "words"
PAGES = ("index.html", "embed.html")
# Scripts that the notebook widget does without.
APART = ("embed.js", "hophoop-motion.js")


@cache
def languages() -> tuple[str, ...]:
    """Return the codes of the languages other than English, which is in the script."""
    return tuple(sorted(path.name.removesuffix(".json") for path in _WORDS.iterdir() if path.name != "en.json"))


@cache
def packed_words() -> bytes:
    """Return the words of all languages compressed by gzip, for the notebook widget."""
    tables = {code: json.loads((_WORDS / f"{code}.json").read_bytes()) for code in languages()}
    return gzip.compress(json.dumps(tables, ensure_ascii=False).encode(), 9, mtime=0)


@cache
def visited() -> tuple[str, ...]:
    """Return the names of the files of static/ that visitors load."""
    return tuple(sorted(path.name for path in _STATIC.iterdir() if path.name not in (*OWN, *PAGES)))


@cache
def scripts() -> dict[str, str]:
    """Return the page's scripts by name, for the notebook widget."""
    return {name: static_text(name) for name in visited() if name.endswith(".js") and name not in APART}


def static_bytes(name: str) -> bytes:
    """Return the content of a file of static/."""
    return (_STATIC / name).read_bytes()


@cache
def static_text(name: str) -> str:
    """Return the text of a file of static/."""
    return static_bytes(name).decode()


def page_text(name: str) -> str:
    """Return a page whose request for the module has the hash with which the script asks for it."""
    return static_text(name).replace("{module}", built()["module"])


@cache
def packed_module(name: str = MODULE) -> bytes:
    """Return a module compressed by gzip, for the notebook widget."""
    return gzip.compress((files("hophoop.lab.wasm") / name).read_bytes(), 9, mtime=0)


def site_files(docs: str = "", url: str = "") -> dict[str, bytes]:
    """Return the site's files by their path.

    Parameters
    ----------
    docs : str, default ''
        Location of the documentation, for teachers: an address, or a path relative to the site; none by default.
    url : str, default ''
        Address of the site, which previews of links need for their picture; none by default.

    Returns
    -------
    files : dict
        With relative paths throughout, so that the folder can be at any address.
    """
    made = {f"static/{name}": static_bytes(name) for name in visited()}
    for code in languages():
        made[f"static/words.{code}.json"] = (_WORDS / f"{code}.json").read_bytes()
    for name in (MODULE, DERIVATIVES):
        made[f"static/{name}"] = (files("hophoop.lab.wasm") / name).read_bytes()
    for name in PAGES:
        page = page_text(name).encode().replace(b"{policy}", POLICY.encode())
        page = page.replace(b'="og:image" content="', b'="og:image" content="' + _address_of(url))
        made[name] = page.replace(b"<title>", _place_of(docs) + b"<title>", 1)
    made["manifest.webmanifest"] = json.dumps(_manifest(), ensure_ascii=False, indent=1).encode()
    digest = hashlib.sha256()
    for name, content in sorted(made.items()):
        digest.update(name.encode() + hashlib.sha256(content).digest())
    listed = ", ".join(json.dumps(name) for name in ("./", *sorted(made)))
    worker = static_text("service-worker.js")
    made["service-worker.js"] = (
        worker.replace("{version}", digest.hexdigest()[:16]).replace('"{files}"', listed).encode()
    )  # fmt: skip
    return made


def _place_of(docs: str) -> bytes:
    """Return the HTML that gives the page the location of the documentation."""
    scheme = re.match(r"[^/?#]*?:", docs.strip())  # browsers ignore leading spaces and control characters
    if (scheme and scheme[0].lower() not in ("http:", "https:")) or not docs.isprintable():
        raise InputError.of_field("--docs", docs, "an address of http or https, or a path such as ../")
    if not docs:
        return b""
    return f'<meta name="hophoop-docs" content="{html.escape(docs.rstrip("/"))}/">\n'.encode()


def _address_of(url: str) -> bytes:
    """Return the address of the site as it is written in HTML, with a slash at the end."""
    if not re.fullmatch(r"https?://[^\s\"<>]+", url or "http://none"):
        raise InputError.of_field("--url", url, "an address of http or https")
    return f"{html.escape(url.rstrip('/'))}/".encode() if url else b""


def _manifest() -> dict[str, object]:
    return {
        "name": "hophoop lab",
        "short_name": "hophoop",
        "description": "A ring with a load on its rim rolls, slips, hops and lands: exact motion, live.",
        "start_url": "./",
        "display": "standalone",
        "background_color": "#ffffff",
        "theme_color": "#ffffff",
        "icons": [{"src": "static/icon.svg", "sizes": "any", "type": "image/svg+xml"}],
    }


def export(folder: Path, docs: str = "", url: str = "") -> list[Path]:
    """Write the lab as a folder of files.

    Parameters
    ----------
    folder : Path
        A new or empty folder, or one with an earlier export.
    docs : str, default ''
        Location of the documentation, for teachers: an address, or a path relative to the folder; none by default.
    url : str, default ''
        Address at which the folder will be, which previews of links need for their picture; none by default.

    Returns
    -------
    files : list of Path

    Raises
    ------
    ValueError
        If the folder contains anything else.
    OSError
        If the files cannot be written.
    """
    made = site_files(docs, url)
    if folder.exists() and not folder.is_dir():
        raise InputError(f"--export {folder} must be a folder.")
    if folder.is_dir() and any(folder.iterdir()) and not (folder / "service-worker.js").is_file():
        raise InputError(f"--export {folder} must be a new or an empty folder; it holds other files.")
    written = []
    for name, content in made.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        with replacing(path) as fresh:
            fresh.write_bytes(content)
        written.append(path)
    return written


def summary(folder: Path, written: list[Path]) -> str:
    """Return a sentence or two about the files written.

    Parameters
    ----------
    folder : Path
    written : list of Path

    Returns
    -------
    text : str
    """
    size = sum(path.stat().st_size for path in written)
    return (
        f"{folder}: hophoop {__version__}, {len(written)} files, {size / 1e6:.1f} MB. Any web host can serve them; "
        f"to try them here: python -m http.server --directory {folder}"
    )
