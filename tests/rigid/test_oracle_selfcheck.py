"""The oracles against the Lagrangian and their own kept solutions, without the program: a judge must be sound."""

from __future__ import annotations

import json

import numpy as np
import pytest
from mpmath import mp, mpf

from oracle_program import DATA, STATE
from oracles import mechanics, precise
from oracles.cases import Case, by_name


def test_mass_matrix_and_forces_follow_from_the_lagrangian() -> None:
    """Euler–Lagrange equations, formed symbolically from the place of G alone, equal oracles.mechanics."""
    import sympy

    t = sympy.symbols("t")
    m, radius, eps, kappa, g, beta = sympy.symbols("m R epsilon kappa g beta", positive=True)
    x, y, theta = (sympy.Function(name)(t) for name in ("x", "y", "theta"))
    along = x + eps * radius * sympy.sin(theta)
    off = radius + y + eps * radius * sympy.cos(theta)
    kinetic = m * (along.diff(t) ** 2 + off.diff(t) ** 2) / 2 + kappa * m * radius**2 * theta.diff(t) ** 2 / 2
    potential = m * g * (off * sympy.cos(beta) - along * sympy.sin(beta))
    lagrangian = kinetic - potential
    coordinates = (x, y, theta)
    equations = [sympy.expand(lagrangian.diff(q.diff(t)).diff(t) - lagrangian.diff(q)) for q in coordinates]
    accelerations = [q.diff(t, 2) for q in coordinates]
    mass = sympy.Matrix([[equation.coeff(a) for a in accelerations] for equation in equations])
    rest = [-equation.subs(dict.fromkeys(accelerations, 0)) for equation in equations]

    # the virtual work of a force (F, N) on the rim's material point at the bottom: its velocity by
    # differentiation
    phi = sympy.symbols("phi")  # the point's own angle on the rim, clockwise from the normal
    point = (x + radius * sympy.sin(theta + phi), radius + y + radius * sympy.cos(theta + phi))
    at_bottom = {phi: sympy.pi - theta}
    jacobian = [[component.diff(q).subs(at_bottom) for q in coordinates] for component in point]

    case = Case("numbers", 0.7, 1.9, 0.55, 0.31, 9.5, 0.23)
    angle, omega = 1.234, -2.5
    numbers = {m: 1.9, radius: 0.7, eps: 0.55, kappa: 0.31, g: 9.5, beta: 0.23}
    # derivatives before the functions they belong to
    speeds = {x.diff(t): 0.4, y.diff(t): -0.3, theta.diff(t): omega}

    def evaluate(expression: sympy.Expr) -> float:
        return float(sympy.sympify(expression).subs(speeds).subs({theta: angle, x: 0.0, y: 0.0}).subs(numbers))

    got = np.array([[evaluate(mass[i, j]) for j in range(3)] for i in range(3)])
    np.testing.assert_allclose(mechanics.mass_matrix(case, angle), got, rtol=1e-14, atol=1e-15)
    forces = [evaluate(expression) for expression in rest]
    np.testing.assert_allclose(mechanics.applied_forces(case, angle, omega), forces, rtol=1e-13)
    contact = np.array([[evaluate(sympy.simplify(entry)) for entry in row] for row in jacobian])
    np.testing.assert_allclose(mechanics.contact_jacobian(case), contact, atol=1e-15)
    velocity = np.array([0.4, -0.3, omega])
    assert mechanics.kinetic_energy(case, angle, velocity) == pytest.approx(evaluate(kinetic), rel=1e-14)
    raised = evaluate(potential - potential.subs({x: 0, y: 0, theta: 0}))
    shown = mechanics.potential_energy(case, 0.0, 0.0, angle)
    assert shown == pytest.approx(raised, rel=1e-13)


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
