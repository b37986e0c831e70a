"""The gallery shows every public function of plots, maps and animate; building the documentation runs its examples."""

import ast
import inspect
import sys
from pathlib import Path

import pytest

import hophoop as hh

GALLERY = Path(__file__).parents[2] / "examples" / "gallery"
sys.path.insert(0, str(GALLERY.parents[1] / "docs" / "_ext"))
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


WRITERS = {"hh.animate.film", "hh.animate.film_3d", "hh.animate.scene", "hh.animate.player"}


def shows(code):
    """Whether a script, run by itself, opens a window, writes a film or page, or is for notebooks."""
    tree = ast.parse(code)
    called = {ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    return ast.unparse(tree.body[-1]) == "plt.show()" or bool(WRITERS & called)


def test_a_downloaded_example_shows_something_and_says_what():
    for path in EXAMPLES:
        code = path.read_text(encoding="utf-8")
        assert shows(code), path
        assert not shows(code.replace("plt.show()", "").replace("hh.animate.", "hh.other.")), path
        title, line, _, *text = ast.get_docstring(ast.parse(code)).splitlines()
        assert line == "=" * len(title), path
        assert text, path


def test_every_example_has_its_place_from_simple_to_hard():
    gallery = pytest.importorskip("gallery", reason="the extra 'docs' is not installed")
    assert sorted(gallery.ORDER) == sorted(path.stem.removeprefix("plot_") for path in EXAMPLES)
