"""The oracles against each other and against the Lagrangian, without the program: a judge must be sound."""

from __future__ import annotations

import json
from dataclasses import asdict
from fractions import Fraction as Q

import numpy as np
import pytest
from mpmath import mp, mpf

from oracle_program import DATA, STATE, essential, highest_apexes, reference
from oracles import elliptic, hybrid, mechanics, precise, rational
from oracles.cases import ARTICLE, CASES, Case, by_name

# One of every kind of event and law; the rest of the cases run with -m slow.
QUICK = {
    "article_v3.1_mu1",
    "slope_10deg",
    "bounces_poisson",
    "skidding_start",
    "frictionless_fast",
    "impact_without_collision",
    "indeterminate_as_impact",
}


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


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(c, id=c.name, marks=[] if c.name in QUICK else pytest.mark.slow)
        for c in CASES
        if not c.rest_below  # bounces without end are for the series alone
    ],
)
def test_reference_against_dop853(case: Case) -> None:
    """Taylor series in 40 to 52 digits and SciPy's integrator see the same events at the same times."""
    stored, motion = reference(case.name), hybrid.solve(case)
    assert motion.sequence == stored["sequence"]
    assert motion.status == stored["status"]
    theirs, ours = stored["events"], motion.events
    assert [(e["kind"], e["from"], e["to"]) for e in ours] == [(e["kind"], e["from"], e["to"]) for e in theirs]
    for mine, true in zip(ours, theirs, strict=True):
        for name in ("t", *STATE):
            assert mine[name] == pytest.approx(true[name], rel=1e-11, abs=3e-11), (
                true["kind"],
                true["t"],
                name,
            )
    for true in stored["samples"]:
        mine = motion.at(true["t"])
        assert mine["mode"] == true["mode"]
        for name in STATE:
            assert mine[name] == pytest.approx(true[name], rel=1e-11, abs=2e-10), (true["t"], name)
        for name in ("friction", "normal", "work"):
            assert mine[name] == pytest.approx(true[name], rel=1e-10, abs=2e-9), (true["t"], name)
    for name in ("kinetic", "potential", "friction", "impact_normal", "impact_tangential"):
        assert motion.ledger[name] == pytest.approx(stored["energy"][name], abs=2e-10)
    assert abs(motion.ledger["residual"]) < 1e-10


def test_reference_energy_closes() -> None:
    """Nothing in the series solution enforces energy; 30 digits of it remain."""
    for case in CASES:
        stored = json.loads((DATA / f"{case.name}.json").read_text(encoding="utf-8"))
        with mp.workdps(50):
            assert abs(mpf(stored["energy"]["residual"])) < mpf(10) ** -30, case.name
            assert mpf(stored["agreement"]) < mpf(10) ** -24, case.name
        assert stored["case"] == asdict(case), "the case was changed: run tests/data/generate.py"


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


@pytest.mark.parametrize("name", ["article_v0.1_mu1", "article_v2_mu1", "general_body", "scaled_body"])
def test_reference_against_elliptic_time(name: str) -> None:
    """Pure rolling for seconds: the elliptic time to the last angle is the duration."""
    case = by_name(name)
    stored = json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))
    with mp.workdps(40):
        points = [*stored["samples"], stored["events"][-1]]
        for point in points:
            angle, t = mpf(point["angle"]), mpf(point["t"])
            rate = elliptic.rolling_rate(case, angle)
            # the angle is written to 25 digits, which the speed turns into so much time
            assert abs(elliptic.rolling_time(case, angle) - t) < mpf(10) ** -21 / min(rate, 1)
            assert abs(rate - mpf(point["omega"])) < mpf(10) ** -21


def test_elliptic_time_against_quadrature() -> None:
    """Carlson's forms equal the integral they were made from, over several turns."""
    with mp.workdps(25):
        for case in (ARTICLE[0], ARTICLE[2], by_name("general_body")):
            for angle in (mpf("0.01"), mpf(1), mp.pi, mpf(5), 2 * mp.pi, mpf(17)):
                direct = elliptic.rolling_time_by_quadrature(case, angle)
                assert abs(elliptic.rolling_time(case, angle) - direct) < mpf(10) ** -18


DISK = {"eccentricity": Q(0), "inertia_ratio": Q(1, 2), "sine": Q(0), "cosine": Q(1)}
ROD = {"eccentricity": Q(1, 2), "inertia_ratio": Q(39, 100), "sine": Q(-4, 5), "cosine": Q(3, 5)}


def test_rational_impacts_are_the_hand_worked_ones() -> None:
    """Numbers of the derivation in oracles.rational, worked there by hand."""
    spin = (Q(0), Q(-2), Q(3))
    stick = rational.collide(rational.Contact(**DISK, mu_static=Q(1), mu_kinetic=Q(1)), spin, Q(0), "stronge")
    assert stick["velocity"] == (1, 0, 1)
    assert stick["impulse"] == {"normal": 2, "tangential": 1}
    assert (stick["loss_normal"], stick["loss_tangential"]) == (2, Q(3, 2))
    slip = rational.collide(rational.Contact(**DISK, mu_static=Q(1, 4), mu_kinetic=Q(1, 4)), spin, Q(0), "newton")
    assert slip["velocity"] == (Q(1, 2), 0, 2)
    assert (slip["loss_normal"], slip["loss_tangential"]) == (2, Q(9, 8))
    down = (Q(-1), Q(-3), Q(0))
    limit = rational.Contact(**ROD, mu_static=Q(1, 4), mu_kinetic=Q(1, 4))
    held = rational.collide(limit, down, Q(0), "stronge")
    assert held["impulse"] == {"normal": Q(143, 56), "tangential": Q(-101, 224)}
    assert held["velocity"][0] == held["velocity"][2]
    turned = rational.collide(rational.Contact(**ROD, mu_static=Q(1, 8), mu_kinetic=Q(1, 8)), down, Q(0), "stronge")
    assert turned["impulse"] == {"normal": Q(221, 97), "tangential": Q(-31, 194)}
    assert turned["velocity"][0] - turned["velocity"][2] == Q(115, 97)


@pytest.mark.parametrize("law", ["newton", "poisson", "stronge"])
@pytest.mark.parametrize("restitution", [Q(0), Q(1, 4), Q(1, 2), Q(1)])
def test_three_impact_oracles_agree(law: str, restitution: Q) -> None:
    """Exact fractions, straight pieces in mpmath and numerical integration over the impulse."""
    angle = -0.9272952180016122  # sin = −4/5, cos = 3/5 to rounding
    for mu in (Q(1, 8), Q(1, 5), Q(1, 2), Q(6, 5)):
        for velocity in ((Q(-1), Q(-3), Q(0)), (Q(2), Q(-1), Q(1)), (Q(1), Q(-1), Q(1))):
            exact = rational.collide(rational.Contact(**ROD, mu_static=mu, mu_kinetic=mu), velocity, restitution, law)
            case = Case(
                "impact",
                eccentricity=0.5,
                inertia_ratio=0.39,
                mu_static=float(mu),
                mu_kinetic=float(mu),
                restitution=float(restitution),
                impact_law=law,
            )
            state = np.array([0.0, 0.0, angle, *map(float, velocity), 0.0])
            after, more = hybrid.impact(case, state)
            np.testing.assert_allclose(after[3:6], [float(v) for v in exact["velocity"]], atol=3e-13)
            assert more["impulse"]["normal"] == pytest.approx(float(exact["impulse"]["normal"]), rel=1e-12)
            assert more["loss_tangential"] == pytest.approx(float(exact["loss_tangential"]), abs=1e-12)
            assert more["loss_normal"] == pytest.approx(float(exact["loss_normal"]), abs=1e-12)
            with mp.workdps(30):
                parameters = precise.Parameters(case)
                numbers = (
                    mpf(0),
                    mpf(0),
                    mpf(angle),
                    *(mpf(v.numerator) / v.denominator for v in velocity),
                    mpf(0),
                )
                fine = precise.impact(parameters, numbers[:6])
            np.testing.assert_allclose([float(v) for v in fine["velocity"]], [float(v) for v in exact["velocity"]], atol=1e-13)


def test_essential_events_leave_out_only_notes() -> None:
    """The filter that the comparisons use keeps every event that changes the motion."""
    kinds = [{"kind": kind} for kind in ("start", "slip_start", "impact", "kane_gain", "turn", "end")]
    assert [event["kind"] for event in essential(kinds)] == ["slip_start", "impact", "turn"]
    cut = [{"kind": kind} for kind in ("start", "takeoff", "apex", "end")]
    assert [event["kind"] for event in essential(cut)] == ["takeoff"]
    heights = (
        ("takeoff", 0.0),
        ("apex", 1.0),
        ("apex", 2.0),
        ("impact", 0.0),
        ("apex", 0.5),
        ("impact", 0.0),
    )
    flights = [{"kind": kind, "height": height} for kind, height in heights]
    assert [event["height"] for event in highest_apexes(flights)] == [0.0, 2.0, 0.0, 0.5, 0.0]
