"""A defect of hophoop is shown as one, and only bad input as bad input."""

import dask
import pytest

import hophoop as hh
from cli_tools import HOP, done, run
from hophoop._support.extras import MissingExtra
from hophoop.scenario import InputError

DEFECTS = (
    ValueError("operands could not be broadcast together"),
    KeyError("kind"),
    ImportError("cannot import name 'simulate'"),
)


@pytest.fixture
def fails(monkeypatch):
    """Let the computation of a run raise an error; returns what the command says."""

    def of(error):
        def raised(*_, **__):
            raise error

        monkeypatch.setattr("hophoop.simulation.simulate.simulate", raised)
        return run(HOP)

    return of


@pytest.mark.parametrize("error", DEFECTS, ids=lambda error: type(error).__name__)
def test_a_defect_ends_with_its_traceback(error, fails):
    found = fails(error)
    assert (found.exit_code, found.stdout) == (70, "")
    *_, last = found.stderr.splitlines()
    assert found.stderr.startswith("Traceback (most recent call last):")
    assert f"{type(error).__name__}: {error}" in found.stderr
    assert last.startswith(f"This is a defect of hophoop {hh.__version__} or of its installation, not of your input.")
    assert "report it as an issue" in last


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (InputError("speed is too much."), "speed is too much."),
        (OSError("the disk is full."), "the disk is full."),
        (MissingExtra("matplotlib is not installed."), "matplotlib is not installed."),
        (MemoryError(), "There is not enough memory: ask for less."),
        (RuntimeError("can't start new thread"), "There is not enough memory: can't start new thread."),
        (ImportError("libm.so: failed to map segment."), "There is not enough memory: libm.so: failed to map segment."),
        (OSError(12, "Cannot allocate memory"), "Cannot allocate memory."),
    ],
)
def test_what_a_user_can_change_is_one_sentence(error, said, fails):
    found = fails(error)
    assert (found.exit_code, found.stderr) == (2, f"Error: {said}\n")


def test_an_address_that_the_library_refuses_changes_nothing(tmp_path):
    found = done(
        "map --axis plane.mu=1:2:3 --axis start.speed=1:2:2 --scheduler x --quiet --out", tmp_path / "a.zarr", status=2
    )
    assert found.stderr.startswith("Error: --scheduler = 'x' must be an address")
    assert found.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
    assert dask.config.get("scheduler", None) is None  # the next map is computed by this machine again
