"""What is compiled beside is what motions then call."""

import pytest

import hophoop as hh
from hophoop import simulation
from hophoop._jit.kernels import describe
from hophoop._jit.policy import Kernel
from hophoop.compliant import kernel as compliant
from hophoop.rigid import sampling


def noted(kernel, monkeypatch):
    """The kinds of arguments that a kernel is called with from now on."""
    found = []

    def call(*arguments):
        found.append(tuple(describe(value) for value in arguments))
        return kernel.interpreted(*arguments)

    monkeypatch.setattr(kernel, "_target", call)
    return found


@pytest.mark.parametrize(
    ("contact", "parts"),
    [(hh.Rigid(), [sampling.sample, simulation.run]), (hh.Compliant(), [compliant.run_into])],
)
def test_code_is_compiled_for_the_arguments_that_come(monkeypatch, contact, parts):
    asked = []
    monkeypatch.setattr(simulation, "precompile", asked.extend)
    simulation.compile_beside(compliant=True)
    expected = {kernel: tuple(describe(value) for value in arguments) for kernel, arguments in asked}
    assert set(parts) <= set(expected)
    came = {part: noted(part, monkeypatch) for part in parts}
    hh.simulate(hh.Scenario(duration=0.05, contact=contact)).at(0.02)
    for part in parts:
        assert came[part] == [expected[part]]


def test_a_motion_asks_for_one_kernel_only(monkeypatch):
    hh.simulate(hh.Scenario(duration=2.0))  # makes memory, once a thread
    asked = []

    def call(self, *arguments):
        asked.append(self.py_func.__name__)
        return self._target(*arguments)

    monkeypatch.setattr(Kernel, "__call__", call)
    hh.simulate(hh.Scenario(duration=2.0))
    assert asked == ["run"]  # to choose for another what is quicker takes a third as long as a compiled motion
