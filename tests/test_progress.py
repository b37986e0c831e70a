"""Progress: what a function reports, and the bar that a terminal shows of it."""

import time

import pytest
from rich.console import Console

import hophoop as hh
from cli_tools import HOP, run
from hophoop._support import progress as reporting

SOFT = hh.Scenario(contact=hh.Compliant(), duration=0.5)


@pytest.fixture
def terminal(monkeypatch):
    monkeypatch.setattr(Console, "is_terminal", True)
    monkeypatch.setenv("TERM", "xterm")


def slowly(compute):
    def computed(*given):
        result = compute(*given)
        time.sleep(0.05)  # compiled, it would be done before the first report
        return result

    return computed


def test_a_compliant_motion_reports_its_share(monkeypatch):
    from hophoop.simulation import compliant

    monkeypatch.setattr(compliant, "simulate_compliant", slowly(compliant.simulate_compliant))
    monkeypatch.setattr(reporting, "LOOKS", 0.002)
    shares = []
    motion = hh.simulate(SOFT, progress=shares.append)
    assert shares == sorted(shares)
    assert len(shares) > 2
    assert 0.0 <= shares[0] <= shares[-2] <= 1.0 == shares[-1]
    assert motion.tables["segments"].tobytes() == hh.simulate(SOFT).tables["segments"].tobytes()


def test_an_error_of_the_computation_is_raised():
    def breaks(share):
        raise ValueError("hoop.radius is wrong.")

    with pytest.raises(ValueError, match=r"^hoop\.radius is wrong\.$"):
        reporting.compute_reporting(breaks, lambda share: None)


@pytest.mark.parametrize(("soon", "shown"), [(0.0, True), (60.0, False)])
def test_a_long_command_shows_a_bar_on_a_terminal(terminal, monkeypatch, soon, shown):
    monkeypatch.setattr(reporting, "SOON", soon)
    soft = run("run --set contact.model=compliant --duration 0.5").stderr
    assert ("motion" in soft and "%" in soft) == shown
    assert "motion" not in run(f"{HOP} --quiet").stderr


def test_a_bar_counts(terminal, capsys):
    with reporting.bar("frames") as report:
        report(3, 40)
        report(4, 40, "more frames")
    said = capsys.readouterr().err
    assert "more frames" in said
    assert "4/40" in said


@pytest.mark.parametrize(("is_terminal", "quiet"), [(False, False), (True, True)])
def test_there_is_no_bar_without_a_terminal_or_if_switched_off(monkeypatch, capsys, is_terminal, quiet):
    monkeypatch.setattr(Console, "is_terminal", is_terminal)
    with reporting.bar("frames", quiet=quiet) as report:
        assert report is None
    assert capsys.readouterr() == ("", "")


def test_a_map_shows_its_cells_and_their_rate(terminal, capfd):
    hh.maps.sweep(None, {"start.speed": [1.0, 2.0, 3.0], "plane.mu": [0.5, 1.0]}, progress=True, chunk_cells=2)
    shown = capfd.readouterr().err
    assert "6/6" in shown
    assert "per second" in shown
