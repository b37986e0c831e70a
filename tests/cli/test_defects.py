"""A defect of hophoop is shown as one, and only bad input as bad input."""

import pytest

import hophoop as hh
from cli_tools import run
from hophoop._support.extras import MissingExtra
from hophoop.scenario import InputError

DEFECTS = (
    ValueError("operands could not be broadcast together"),
    TypeError("unsupported operand"),
    IndexError("list index out of range"),
    KeyError("kind"),
    ImportError("cannot import name 'simulate'"),
    RuntimeError("no"),
)


def raising(error):
    def raised(*_, **__):
        raise error

    return raised


@pytest.mark.parametrize("error", DEFECTS, ids=lambda error: type(error).__name__)
def test_a_defect_ends_with_its_traceback(error, monkeypatch):
    monkeypatch.setattr("hophoop.simulation.simulate.simulate", raising(error))
    done = run("run", "--duration", "1")
    assert done.exit_code == 1
    assert done.stdout == ""
    first, *_, last = done.stderr.splitlines()
    assert first == "Traceback (most recent call last):"
    assert "in raised" in done.stderr
    assert f"{type(error).__name__}: {error}" in done.stderr
    assert last.startswith(f"This is a defect of hophoop {hh.__version__} or of its installation, not of your input.")
    assert "report it as an issue" in last
    assert "Error: " not in (first, last)


@pytest.mark.parametrize(
    "error",
    [
        InputError("speed is too much."),
        OSError("the disk is full."),
        MissingExtra("matplotlib is not installed."),
    ],
    ids=lambda error: type(error).__name__,
)
def test_what_a_user_can_change_is_one_sentence(error, monkeypatch):
    monkeypatch.setattr("hophoop.simulation.simulate.simulate", raising(error))
    done = run("run", "--duration", "1")
    assert (done.exit_code, done.stderr) == (2, f"Error: {error}\n")


@pytest.mark.parametrize(
    "error",
    [
        MemoryError(),
        RuntimeError("can't start new thread"),
        ImportError("libm.so: failed to map segment from shared object"),
        OSError(12, "Cannot allocate memory"),
    ],
    ids=lambda error: type(error).__name__,
)
def test_too_little_memory_is_one_sentence(error, monkeypatch):
    monkeypatch.setattr("hophoop.simulation.simulate.simulate", raising(error))
    done = run("run", "--duration", "1")
    assert done.exit_code == 2
    assert done.stderr.count("\n") == 1
    assert "memory" in done.stderr


def test_an_option_replaces_the_argument_and_no_word_of_the_value():
    done = run("animate", "--out", "a.mp4", "--theme", "start = end")
    assert done.exit_code == 2
    assert done.stderr.startswith("Error: --theme = 'start = end' must be one of ")


@pytest.mark.parametrize(
    ("command", "name", "content", "said"),
    [
        (
            ["prove", "--check"],
            "a.json",
            "{" + f'"t": {"9" * 5000}' + "}",
            "must be a certificate in JSON: a number has too many",
        ),
        (["prove", "--check"], "a.json", "[" * 100_000, "must be a certificate in JSON: nested too deeply"),
        (["lab"], "a.json", '{"schema": "hophoop-fit/1", "values": {}, "free": [], "covariance": "much"}', "is incomplete"),
    ],
)
def test_files_that_libraries_refuse(command, name, content, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_text(content, encoding="utf-8")
    done = run(*command, name)
    assert done.exit_code == 2, done.stderr[-2000:]
    assert done.stderr.startswith("Error: ")
    assert done.stderr.count("\n") == 1
    assert name in done.stderr
    assert said in done.stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["run", "--set", f"hoop.parts.{'9' * 5000}.mass=1"], "Error: "),
        (
            ["map", "--axis", "plane.mu=1:inf:3:log", "--axis", "start.speed=1:2:2", "--out", "a.zarr"],
            "Error: end of a logarithmic axis = inf must be",
        ),
        (
            [
                "map",
                "--axis",
                "plane.mu=1:2:3",
                "--axis",
                "start.speed=1:2:2",
                "--out",
                "a.zarr",
                "--scheduler",
                "x",
                "--quiet",
            ],
            "Error: --scheduler = 'x' must be an address",
        ),
    ],
)
def test_words_that_libraries_refuse(words, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = run(*words)
    assert done.exit_code == 2, done.stderr[-2000:]
    assert done.stderr.startswith(said)
    assert done.stderr.count("\n") == 1
