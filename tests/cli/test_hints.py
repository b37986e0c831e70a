"""What the command line says to someone who types what the Python pages or another language would write."""

import dataclasses
import socket

import pytest
from typer.testing import CliRunner

from hophoop.cli import app, command_of
from hophoop.tracking import Hints


def said(*arguments):
    done = CliRunner().invoke(app, [str(part) for part in arguments])
    assert done.exit_code == 2, done.output
    return " ".join(done.output.split())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("run", "--v0", "3,1"), "Error: --v0 = '3,1' must be a number, such as 3.1. See hophoop run --help."),
        (("track", "a.mp4", "--radius", "30cm"), "Error: --radius = '30cm' must be a number, such as 3.1."),
        (("lab", "--port", "many"), "Error: --port = 'many' must be a whole number, such as 3."),
    ],
)
def test_a_number_that_is_none(arguments, message):
    assert message in said(*arguments)


@pytest.mark.parametrize(
    ("command", "option", "right"),
    [
        ("run", "--speed", "(Possible options: --v0)"),
        ("run", "--load-fraction", "(Possible options: --gamma)"),
        ("run", "--load_fraction", "(Possible options: --gamma)"),
        ("run", "--slop", "--slope"),
        ("track", "--speed", "No such option: --speed"),
    ],
)
def test_a_name_of_python_leads_to_the_option(command, option, right):
    text = said(command, option, "0.5")
    assert right in text
    assert command == "run" or "--v0" not in text  # it has none


def test_the_letters_are_explained_without_symbols():
    done = CliRunner().invoke(app, ["run", "--v0", "3.1", "--duration", "2"])
    text = " ".join(done.stdout.split())
    assert "(R roll, S spin, K skid, H flight, M skim)" in text


def test_a_port_in_use_leads_to_a_free_one():
    pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        assert "0 takes a free port" in said("lab", "--no-browser", "--port", taken.getsockname()[1])


def test_an_option_is_declared_where_its_value_is_used():
    """Type, default and text are those of the dataclass; the command names the option and its place in the help."""
    options = {option.name: option for option in command_of("track").params}
    for field in dataclasses.fields(Hints):
        assert options[field.name].default == field.default, field.name
    assert options["level"].opts == ["--level-deg"]
    assert options["level"].help == "Rise of a level line to the right in the picture, degrees."
    assert options["ring"].help == "The rim against its background: auto, dark or light."
