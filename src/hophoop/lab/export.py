"""The lab as a folder of static files, which any web host can serve, or as one file: the visitor's browser computes."""

from __future__ import annotations

import base64
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
from hophoop.lab.wasm.stamp import FATES, MODULE, built
from hophoop.scenario import InputError

# Nothing may be loaded from or sent to other sites. Browsers accept frame-ancestors only as a header, not from the page.
POLICY = (
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; img-src 'self' data: blob:; "
    "media-src 'self' blob:; style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'none'; form-action 'none'"
)
# Of one file, which loads nothing; its own script is named by its hash.
FILE_POLICY = (
    "default-src 'none'; script-src 'sha256-{script}' blob: 'wasm-unsafe-eval'; worker-src blob:; img-src data: blob:; "
    "media-src blob:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"
)
# Files of static/ that are not for visitors: other pages, and what Python fills or a notebook or a file starts with.
OWN = ("backdrop.js", "file.js", "pick.html", "play.html", "service-worker.js", "tables.json", "widget.js", "worker.js")
_STATIC = files("hophoop.lab") / "static"
_WORDS = files("hophoop.lab") / "words"
PAGES = ("index.html", "embed.html")
# Scripts of a folder that a notebook and a file do without.
APART = ("embed.js", "hophoop-motion.js", "kernel.js")


@cache
def languages() -> tuple[str, ...]:
    """Return the codes of the languages other than English, which is in the script."""
    return tuple(sorted(path.name.removesuffix(".json") for path in _WORDS.iterdir() if path.name != "en.json"))


@cache
def packed_words() -> bytes:
    """Return the words of all languages compressed by gzip, for a notebook or a file."""
    tables = {code: json.loads((_WORDS / f"{code}.json").read_bytes()) for code in languages()}
    return gzip.compress(json.dumps(tables, ensure_ascii=False).encode(), 9, mtime=0)


@cache
def visited() -> tuple[str, ...]:
    """Return the names of the files of static/ that visitors load."""
    return tuple(sorted(path.name for path in _STATIC.iterdir() if path.name not in (*OWN, *PAGES)))


@cache
def scripts() -> dict[str, str]:
    """Return the page's scripts by name, for a notebook or a file."""
    names = [name for name in visited() if name.endswith(".js") and name not in APART]
    return {name: static_text(name) for name in (*names, "worker.js")}


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
    """Return a module compressed by gzip, for a notebook or a file."""
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
    for name in (MODULE, FATES):
        made[f"static/{name}"] = (files("hophoop.lab.wasm") / name).read_bytes()
    folder = _address_of(f"{url.rstrip('/')}/") if url else ""
    for name in PAGES:
        page = page_text(name).replace("{policy}", POLICY).replace('="og:image" content="', f'="og:image" content="{folder}')
        made[name] = page.replace("<title>", f"{_place_of(docs)}<title>", 1).encode()
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


def page_file(docs: str = "", url: str = "") -> str:
    """Return the lab as one page, which opens from a disk, without a server or a network.

    Parameters
    ----------
    docs : str, default ''
        Address of the documentation, for teachers; none by default.
    url : str, default ''
        Address at which the page will be, with which copied links begin; none by default.

    Returns
    -------
    page : str
    """
    packed = {
        "scripts": gzip.compress(json.dumps(scripts()).encode(), 9, mtime=0),
        "words": packed_words(),
        "module": packed_module(),
        "fates": packed_module(FATES),
    }
    script = static_text("file.js")
    held = [
        f'<script type="application/gzip" id="packed-{name}">{_base64(content)}</script>\n' for name, content in packed.items()
    ]
    values = {
        "policy": FILE_POLICY.format(script=_base64(hashlib.sha256(script.encode()).digest())),
        "places": _place_of(docs) + (f'<meta name="hophoop-url" content="{_address_of(url)}">\n' if url else ""),
        "icon": _base64(static_bytes("icon.svg")),
        "style": static_text("lab.css"),
        "licences": static_text("licences.txt"),
        "packed": "".join(held),
        "script": script,
    }
    return re.sub(r"\{(\w+)\}", lambda place: values[place[1]], static_text("play.html"))


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode()


def _place_of(docs: str) -> str:
    """Return the HTML that gives the page the location of the documentation."""
    scheme = re.match(r"[^/?#]*?:", docs.strip())  # browsers ignore leading spaces and control characters
    if (scheme and scheme[0].lower() not in ("http:", "https:")) or not docs.isprintable():
        raise InputError.of_field("--docs", docs, "an address of http or https, or a path such as ../")
    if not docs:
        return ""
    return f'<meta name="hophoop-docs" content="{html.escape(docs.rstrip("/"))}/">\n'


def _address_of(url: str) -> str:
    """Return an address as it is written in HTML."""
    if not re.fullmatch(r"https?://[^\s\"<>]+", url):
        raise InputError.of_field("--url", url, "an address of http or https")
    return html.escape(url)


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
    """Write the lab as a folder of files, or as one file.

    Parameters
    ----------
    folder : Path
        A new or empty folder, or one with an earlier export; with a name that ends in .html, a new file.
    docs : str, default ''
        Location of the documentation, for teachers: an address, or a path relative to the folder; none by default.
    url : str, default ''
        Address at which it will be, which previews of links need for their picture, and copied links of a file for
        their start; none by default.

    Returns
    -------
    files : list of Path

    Raises
    ------
    ValueError
        If the folder contains anything else, or the file exists.
    OSError
        If the files cannot be written.
    """
    if folder.suffix.lower() == ".html":
        return [_write_file(folder, page_file(docs, url))]
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


def _write_file(path: Path, page: str) -> Path:
    """Write a file that is not there yet."""
    if path.exists():
        raise InputError(f"--export {path} exists already: remove it, or give another name.")
    with replacing(path) as fresh:
        fresh.write_bytes(page.encode())
    return path


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
    if written == [folder]:
        return f"{folder}: hophoop {__version__}, one file, {size / 1e6:.1f} MB. A double click opens it, also offline."
    return (
        f"{folder}: hophoop {__version__}, {len(written)} files, {size / 1e6:.1f} MB. Any web host can serve them; "
        f"to try them here: python -m http.server --directory {folder}"
    )
