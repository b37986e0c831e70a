"""The article's motions and its checked statements, computed once."""

import pytest

import hophoop as hh
from hophoop.article.figures import FIGURES
from hophoop.article.runs import Runs


@pytest.fixture(scope="session")
def runs():
    return Runs()


@pytest.fixture(scope="session")
def statements(runs):
    return hh.article.statements(runs)


@pytest.fixture(scope="session")
def found(statements):
    """Statements by their keys."""
    return {one.key: one for one in statements}


@pytest.fixture(scope="session")
def numbers(statements):
    """Their numbers, by the same keys."""
    return {one.key: one.numbers for one in statements}


@pytest.fixture
def folder(tmp_path):
    """A folder with an empty drawing for each figure of the report: drawing them takes most of the time."""
    (tmp_path / "figures").mkdir()
    for figure in FIGURES:
        (tmp_path / "figures" / f"{figure.name}.svg").write_text(
            "<svg xmlns='http://www.w3.org/2000/svg'></svg>", encoding="utf-8"
        )
    return tmp_path
