"""The oracles against Newton and Euler and their own kept solutions, without the program: a judge must be sound."""

from __future__ import annotations

import json

import numpy as np
import pytest
from mpmath import mp, mpf

from hophoop.kernel.physics.body import Body
from newton_euler import BODIES, STATES, accelerations, energy
from oracle_program import DATA, STATE
from oracles import mechanics, precise
from oracles.cases import Case, by_name


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize(("th", "om"), STATES)
def test_mechanics_are_those_of_newton_and_euler(body: Body, th: float, om: float) -> None:
    """Mass matrix, contact and energies, against equations that are written another way (units of R, m and g)."""
    case = Case("numbers", 1.0, 1.0, body.eps, body.kap, 1.0, body.slope)
    mass, applied = mechanics.mass_matrix(case, th), mechanics.applied_forces(case, th, om)
    for mode in ("roll", "free"):
        *motion, friction, normal = accelerations(body, th, om, mode)
        forces = applied + mechanics.contact_jacobian(case).T @ [friction, normal]
        np.testing.assert_allclose(mass @ motion, forces, rtol=1e-12, atol=1e-13)
    kinetic, potential = energy(body, 0.7, 0.3, th, 0.4, -0.2, om)
    assert mechanics.kinetic_energy(case, th, np.array([0.4, -0.2, om])) == pytest.approx(kinetic, rel=1e-14)
    zero = energy(body, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)[1]
    assert mechanics.potential_energy(case, 0.7, 0.3, th) - mechanics.potential_energy(case, 0.0, 0.0, 0.0) == pytest.approx(
        potential - zero, rel=1e-12, abs=1e-13
    )


def test_reference_is_what_the_generator_makes() -> None:
    """One case solved again, with other digits and another order, equals the stored strings."""
    case = by_name("bounces_stronge")
    stored = json.loads((DATA / f"{case.name}.json").read_text(encoding="utf-8"))
    solution = precise.solve(case, digits=32, order=36)
    assert len(solution.events) == len(stored["events"])
    with mp.workdps(40):
        for mine, true in zip(solution.events, stored["events"], strict=True):
            assert mine["kind"] == true["kind"]
            for name in ("t", *STATE):
                assert abs(mine[name] - mpf(true[name])) < mpf(10) ** -22, (true["kind"], name)
