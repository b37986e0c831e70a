"""The gallery shows every public function of plots, maps and animate; building the documentation runs its examples."""

import ast
import inspect
from pathlib import Path

import pytest

import hophoop as hh

GALLERY = Path(__file__).parents[2] / "examples" / "gallery"
EXAMPLES = sorted(GALLERY.glob("*/plot_*.py"))
# `hophoop reproduce` makes the article's films, which take minutes
ELSEWHERE = {"article_films"}


def used(path):
    """Names of a room that an example uses, such as 'plots.gap'."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Attribute):
            yield f"{node.value.attr}.{node.attr}"


@pytest.mark.parametrize("room", ["plots", "maps", "animate"])
def test_every_function_has_an_example(room):
    module = getattr(hh, room)
    wanted = {
        f"{room}.{name}"
        for name in module.__all__
        if inspect.isfunction(inspect.unwrap(getattr(module, name))) and name not in ELSEWHERE
    }
    assert len(wanted) > 4
    assert wanted <= {name for path in EXAMPLES for name in used(path)}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_says_what_it_shows(path):
    words = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))
    title, line, _, *text = words.splitlines()
    assert line == "=" * len(title)
    assert text
