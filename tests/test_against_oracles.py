"""The comparison with independent truths finds nothing in random motions, and a program that is a little wrong."""

import pytest

import against_oracles
import hophoop as hh

RIGHT = hh.simulate


def heavier(scenario, **options):
    """A motion with a pull that is 10⁻⁷ too strong."""
    return RIGHT(scenario.replace("plane.gravity", scenario.plane.gravity * (1.0 + 1e-7)), **options)


def test_nothing_is_off_in_two_motions():
    assert [*against_oracles.problems(8), *against_oracles.problems(15)] == []


@pytest.mark.parametrize("seed", [pytest.param(8, marks=pytest.mark.long), 15])  # without and with a resistance to rolling
def test_a_wrong_program_is_found(seed, monkeypatch, capsys):
    monkeypatch.setattr(hh, "simulate", heavier)
    found = " ".join(against_oracles.problems(seed))
    assert {"motion:", "points:", "digits:"} <= set(found.split())
    assert against_oracles.main(["--seed", str(seed), "--count", "1"]) == 1
    assert f"--seed {seed} --count 1" in capsys.readouterr().out


def test_a_wrong_derivative_is_found(monkeypatch):
    def larger(self, *given):
        found = TRUE(self, *given)
        found.larger[:] *= 1.01
        return found

    TRUE = hh.Trajectory.sensitivity
    monkeypatch.setattr(hh.Trajectory, "sensitivity", larger)
    assert "derivatives:" in " ".join(against_oracles.problems(8))


def test_a_motion_that_ends_too_late_is_found(monkeypatch):
    def late(scenario, until=None, **options):
        return RIGHT(scenario, until=until and until.replace("0.5", "0.6"), **options)

    monkeypatch.setattr(hh, "simulate", late)
    assert "parts:" in " ".join(against_oracles.problems(8))
