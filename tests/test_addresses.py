"""The owners' addresses: one file has them, what is empty is listed, and what is there is wherever it belongs."""

import re
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[1]
ADDRESSES = tomllib.loads((ROOT / "addresses.toml").read_text(encoding="utf-8"))
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
CITATION = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
README = (ROOT / "README.md").read_text(encoding="utf-8")
# Where an address belongs as well, once it is known.
PLACES = {
    "repository": lambda: [PROJECT.get("urls", {}).get("Source"), CITATION.get("repository-code")],
    "documentation": lambda: [PROJECT.get("urls", {}).get("Documentation"), CITATION.get("url")],
    "lab": lambda: [PROJECT.get("urls", {}).get("Lab")],
    "issues": lambda: [PROJECT.get("urls", {}).get("Issues")],
    "security": list,
    "conduct": list,
    "doi": lambda: [CITATION.get("doi")],
    "authors": lambda: [[each["name"] for each in PROJECT["authors"]]],
}


def wanting(addresses, places):
    """Addresses that are known, and missing where they belong."""
    return [name for name, value in addresses.items() if value and any(each != value for each in places[name]())]


@pytest.mark.parametrize("name", ADDRESSES)
def test_an_address_is_known(name):
    if not ADDRESSES[name]:
        pytest.xfail(f"addresses.toml has no {name} yet")


def test_known_addresses_are_where_they_belong():
    assert ADDRESSES.keys() == PLACES.keys()
    assert wanting(ADDRESSES, PLACES) == []
    assert wanting({"doi": "10.5281/zenodo.1"}, PLACES) == ["doi"]


def test_links_of_the_readme_work_elsewhere_once_there_is_a_place_for_them():
    """An index shows the README without the files next to it."""
    targets = re.findall(r"\]\(([^)]+)\)", README)
    assert len(targets) > 8
    assert all((ROOT / target).exists() or target.startswith("https://") for target in targets)
    if ADDRESSES["repository"]:
        assert [target for target in targets if not target.startswith("https://")] == []


ASKS = re.compile(r"(?:open|file|write) an issue|please (?:send|report)|under the tab|send (?:us|better)", re.IGNORECASE)
NAMES_IT = re.compile(r"addresses\.toml|\{doc\}`[./]*faq`|% generated: addresses")


def without_address(text):
    """Paragraphs that ask the reader to write, and do not say where."""
    return [each for each in re.split(r"\n\s*\n", text) if ASKS.search(each) and not NAMES_IT.search(each)]


@pytest.mark.parametrize(
    "path",
    [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").rglob("*.md"))],
    ids=lambda path: path.relative_to(ROOT).as_posix(),
)
def test_a_page_that_asks_to_write_says_where(path):
    if "gallery" not in path.parts:
        assert without_address(path.read_text(encoding="utf-8")) == []


def test_a_page_that_does_not_say_where_is_found():
    assert without_address("Good.\n\nOpen an issue.\n\nOpen an issue ({doc}`../faq`).") == ["Open an issue."]
