"""The gallery shows every public function of plots, maps and animate; building the documentation runs its examples."""

import ast
import inspect

import pytest

import hophoop as hh
from checkout import ROOT

GALLERY = ROOT / "examples" / "gallery"
EXAMPLES = sorted(GALLERY.glob("*/plot_*.py"))


WRITERS = {"hh.animate.film", "hh.animate.film_3d", "hh.animate.scene", "hh.animate.player"}


def shows(code):
    """Whether a script, run by itself, opens a window, writes a film or page, or is for notebooks."""
    tree = ast.parse(code)
    called = {ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    return ast.unparse(tree.body[-1]) == "plt.show()" or bool(WRITERS & called)


@pytest.mark.parametrize("room", ["plots", "maps", "animate"])
def test_every_function_has_an_example(room):
    module, text = getattr(hh, room), "".join(path.read_text(encoding="utf-8") for path in EXAMPLES)
    functions = [name for name in module.__all__ if inspect.isfunction(inspect.unwrap(getattr(module, name)))]
    assert len(functions) > 4
    assert [name for name in functions if f".{room}.{name}(" not in text] == []


def test_a_downloaded_example_shows_something_and_says_what():
    assert not shows("import hophoop as hh\nhh.plots.gap(motion)\n")
    for path in EXAMPLES:
        code = path.read_text(encoding="utf-8")
        assert shows(code), path
        title, line, _, *text = ast.get_docstring(ast.parse(code)).splitlines()
        assert line == "=" * len(title), path
        assert text, path
