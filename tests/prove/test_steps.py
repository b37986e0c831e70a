"""Taylor models and steps against the truth in 60 digits: what they bound, and that it is little."""

import itertools
import math
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from mpmath import mp

flint = pytest.importorskip("flint")

from hophoop.precise.problem import Problem  # noqa: E402
from hophoop.prove import contact as contact_module  # noqa: E402
from hophoop.prove import models  # noqa: E402
from hophoop.prove.contact import Contact, Step  # noqa: E402
from hophoop.prove.models import Model, modelled, sine_cosine  # noqa: E402
from hophoop.prove.motion import Run  # noqa: E402
from hophoop.prove.numbers import Unclear, arb, arb_poly, ball, raw, setting  # noqa: E402
from hophoop.prove.roots import first_root  # noqa: E402
from oracle_program import scenario_of  # noqa: E402
from oracles import precise  # noqa: E402
from oracles.cases import Case  # noqa: E402

POINTS = [Fraction(k, 16) for k in range(17)]
SIDES = (-1, 1)


def exactly(number):
    return arb(flint.fmpq(Fraction(number).numerator, Fraction(number).denominator))


def value_of(model, x, side=0):
    """A function within a model at a place: its polynomial, or one that is as far from it as it may be."""
    with setting(400):
        return model.p(exactly(x)) + side * model.e


def holds(model, truth, most=1e-3):
    """The model is within its bound of a function, and the bound is small."""
    with setting(400):
        assert 0 <= float(model.e) < most
        assert all(abs(model.p(exactly(x)) - truth(x)) <= model.e + arb(2) ** -90 for x in POINTS)


A = Model(arb_poly([2, 0.5, -0.25, 0.125, 0.0625, -0.5]), 1e-4)
B = Model(arb_poly([-1.5, 0.75, 0.25, -0.125, 0.5, 0.25]), 3e-5)


@pytest.mark.parametrize("cap", [3, 6, 40])
@pytest.mark.parametrize("name", ["add", "sub", "mul", "truediv", "radd", "rsub", "rtruediv", "times"])
def test_arithmetic_of_models_holds_whatever_is_within_its_operands(name, cap):
    """Operands at both ends of what they bound; short series make what is cut off large."""
    operations = {
        "add": (lambda a, b: a + b), "sub": (lambda a, b: a - b), "mul": (lambda a, b: a * b), "truediv": (lambda a, b: b / a),
        "radd": (lambda a, b: 3 + a), "rsub": (lambda a, b: 3 - a), "rtruediv": (lambda a, b: 3 / a),
        "times": (lambda a, b: ball(-1.25) * a / 3),
    }  # fmt: skip
    compute = operations[name]
    with setting(100, cap):
        found = compute(A, B)
    for first, second in itertools.product(SIDES, SIDES):
        with setting(400):
            holds(found, lambda x, first=first, second=second: raw(compute(value_of(A, x, first), value_of(B, x, second))), 3.0)
    if cap == 40:
        assert float(found.e) < 2e-3
    assert not (name in ("mul", "truediv") and cap == 3 and float(found.e) < 0.01)


def test_the_product_of_two_wide_models_is_as_wide_as_it_has_to_be():
    """The errors multiply too: 2 · 0.5 + 3 · 0.25 + 0.5 · 0.25."""
    wide, other = Model(arb_poly([2]), 0.25), Model(arb_poly([-3]), 0.5)
    with setting(100, 10):
        assert float((wide * other).e) == pytest.approx(2 * 0.5 + 3 * 0.25 + 0.125, rel=1e-8)
        assert float((wide * -2).e) == pytest.approx(0.5, rel=1e-8)
        assert float((wide + other).e) == float((wide - other).e) == pytest.approx(0.75, rel=1e-8)


def test_a_reciprocal_near_zero_is_refused():
    with setting(100, 30), pytest.raises(ZeroDivisionError):
        Model(arb_poly([1, -0.75]), 0.2).inverse()


def test_a_cut_keeps_what_it_leaves_out():
    with setting(100, 3):
        p, e = models.cut([arb(1, 0.01), arb(2, 0.02), arb(-1), arb(0.5, 0.25), arb(-0.25)])
    assert [float(one) for one in p.coeffs()] == [1.0, 2.0, -1.0]
    assert 0.03 + 0.5 <= float(e) < 0.03 + 1.2
    assert float(models.cut([arb(1, 0.01)])[1]) == pytest.approx(0.01, rel=1e-6)


@pytest.mark.parametrize(("terms", "bits"), [(4, 150), (8, 150), (40, 150), (40, 8)])
def test_sine_and_cosine_of_a_polynomial(terms, bits):
    """With few terms the series are cut off, with few bits their first coefficients are rounded."""
    angle = arb_poly([0.7, 0.5, -0.25, 0.125])
    with setting(bits, terms):
        s, c = sine_cosine(angle)
    for x in POINTS:
        with setting(400):
            sine, cosine = angle(exactly(x)).sin_cos()
            assert abs(s.p(exactly(x)) - sine) <= s.e
            assert abs(c.p(exactly(x)) - cosine) <= c.e
            rate = angle.derivative()(exactly(x))
            left = abs(s.p.derivative()(exactly(x)) - c.p(exactly(x)) * rate)
            assert left + abs(c.p.derivative()(exactly(x)) + s.p(exactly(x)) * rate) <= s.e
    assert float(s.e) < {4: 1.0, 8: 0.1, 40: 1e-15 if bits > 8 else 0.2}[terms]
    assert terms > 8 or float(s.e) > 1e-9


@pytest.mark.parametrize("terms", [4, 5])
@pytest.mark.parametrize("begin", [0.0, 0.75, 1.5])
def test_sine_and_cosine_take_up_what_both_leave(begin, terms):
    """Either of both leaves more, by the angle and the number of terms."""
    with setting(100, terms):
        s, c = sine_cosine(arb_poly([begin, 0.125]))
        both = models.size(s.p.derivative() - c.p * 0.125) + models.size(c.p.derivative() + s.p * 0.125)
        assert both <= s.e
        assert both <= c.e
        zero = arb(0)
        sine, cosine = arb(begin).sin_cos()
        assert s.e <= (both + abs(s.p(zero) - sine) + abs(c.p(zero) - cosine)) * (1 + 2.0**-30)


@pytest.mark.parametrize("shift", [-1, 0, 1])
def test_the_first_root_is_bracketed(shift):
    """(x − 0.3)(x − 0.8), lifted or lowered within the bound."""
    p, e = arb_poly([arb("0.24"), arb("-1.1"), 1]), arb(2) ** -60
    with setting(120):
        low, high = first_root(Model(p, e), arb(0), arb(1))
        assert high - low < 1e-15
        root = arb("0.55") - (arb("0.0625") - shift * e).sqrt()
        assert low < root < high
        assert first_root(Model(p + 1, e), arb(0), arb(1)) is None
        assert first_root(Model(p, e), arb(0), arb(0.25)) is None
        low, high = first_root(Model(-p, e), arb(0.5), arb(1))
        assert low < arb("0.8") < high


def test_a_tangency_is_no_root_and_no_gap():
    with setting(100), pytest.raises(Unclear):
        first_root(Model(arb_poly([0.25, -1, 1]), 1e-20), arb(0), arb(1))
    with setting(100):
        assert first_root(Model(arb_poly([0.25 + 1e-9, -1, 1]), 1e-20), arb(0), arb(1)) is None


@pytest.mark.long
def test_online_series_solve_the_equation():
    """θ̈ = sin θ (2 − θ̇²)/(3 + cos θ): the coefficients are those of a motion computed in 60 digits."""
    mp.dps = 60
    with setting(200):
        found = models.rates(lambda s, c, w: s * (2 - w * w) / (3 + c), arb(0.5), arb(1.25), -3, 30)
        modelled(1)
    solved = mp.odefun(
        lambda _, z: [z[1], mp.sin(z[0]) * (2 - z[1] ** 2) / (3 + mp.cos(z[0]))], 0, [mp.mpf("0.5"), mp.mpf("1.25")], degree=60
    )
    for t in (0.05, 0.1):
        value = sum(float(one) * t**k for k, one in enumerate(found))
        assert value == pytest.approx(float(solved(t)[1]), rel=1e-15)


# --- steps of a phase -----------------------------------------------------------------------------------------------------

UNITS = {"gravity": 1.0, "eccentricity": 0.6, "inertia_ratio": 0.3, "slope": 0.1, "mu_static": 5.0, "mu_kinetic": 0.4}
CASES = {
    "R": Case("roll", angle=0.8, vx=0.9, rolling=True, **UNITS),
    "K": Case("skid", angle=0.8, vx=3.0, omega=0.5, **UNITS),
    "S": Case("spin", angle=2.5, vx=-0.5, omega=1.5, **UNITS),
}
SPREAD = Fraction(1, 10**12)


def phase(case, angle=0.0, omega=0.0):
    """(contact, its state) of a case at its start, which is known to these errors."""
    run = Run(Problem.of(scenario_of(case)), ball(1e-12), False, 10, lambda: None)
    start = run.body.start()
    start = start._replace(th=start.th + ball(arb(0, angle)), om=start.om + ball(arb(0, omega)))
    sigma = 0 if case.rolling else 1 if case.vx > case.omega else -1
    return Contact(run.body, sigma, start, 0, start.th), start


def truth(case, angle=0, omega=0):
    """The motion in 40 digits, from a start that is moved a little, with the same speed of the slip."""
    moved = Case(**{**vars(case), "angle": case.angle + angle, "omega": case.omega + omega, "vx": case.vx + omega})
    mp.dps = 40
    return precise.solve(Case(**{**vars(moved), "duration": 0.4}), 30)


@pytest.mark.parametrize("spread", [0.0, 2.0**-40])
@pytest.mark.parametrize("name", CASES)
def test_a_step_holds_every_motion_from_its_start(name, spread):
    case = CASES[name]
    with setting(120):
        step = Step(contact := phase(case, spread, spread)[0], None, arb(0.3))
        assert 0.05 < float(step.h) < 0.31
        assert float(step.error) < (1e-25 if spread == 0.0 else 1e-10)
    moves = [(0, 0)] if spread == 0.0 else list(itertools.product((-spread, spread), repeat=2))
    for angle, omega in moves:
        motion = truth(case, angle, omega)
        for x in (Fraction(1, 4), Fraction(1, 2), Fraction(1)):
            with setting(300):
                within_bounds(case, contact, step, motion, exactly(x))


def within_bounds(case, contact, step, motion, x):
    """θ and θ̇ of a motion lie in a step's enclosures at a place, and the watched functions in its models."""
    tau, th, om = step.at(x)
    man, exponent = (int(part) for part in tau.man_exp())
    one = motion.at(mp.mpf(man) * mp.mpf(2) ** exponent)
    for found, true in ((th, one["angle"]), (om, one["omega"])):
        assert abs(found - arb(mp.nstr(true, 35))).abs_lower() <= arb("1e-30")
    friction, normal, slip = one["friction"], one["normal"], one["vx"] - one["omega"]
    ends = [normal, contact.sigma * slip]
    if contact.sigma == 0:
        ends = [case.mu_static * normal - friction, case.mu_static * normal + friction]
    truths = [*ends, contact.way * one["omega"], 2 * mp.pi - contact.way * (one["angle"] - mp.mpf(case.angle))]
    for model, true in zip(step.models, truths, strict=True):
        assert abs(model.p(x) + arb(0, model.e) - arb(mp.nstr(true, 35))).abs_lower() <= arb("1e-28")


@pytest.mark.parametrize("name", CASES)
def test_the_residual_of_a_step_is_that_of_the_equations(name):
    """θ̇′ − h θ̈ and θ′ − h θ̇ at sampled places, with the error that they let grow, lie below the step's bound."""
    case = CASES[name]
    with setting(100):
        step = Step(contact := phase(case)[0], None, arb(0.3))
    with setting(300):
        worst = arb(0)
        for x in POINTS:
            x = exactly(x)
            s, c = step.th(x).sin_cos()
            left = abs(step.om.derivative()(x) - step.h * contact.alpha(s, c, step.om(x)))
            worst = worst.max(left + step.weight * abs(step.th.derivative()(x) - step.h * step.om(x)))
        assert worst.upper() <= step.error
        assert step.error < 1e8 * worst


@pytest.mark.parametrize("name", CASES)
def test_slopes_hold_wherever_the_motion_may_be(name):
    """The box about a very short step is 10⁻⁶ wide to each side, in θ and in θ̇."""
    with setting(120):
        contact, start = phase(CASES[name])
        step = Step(contact, None, arb(1e-9))
        by_angle, by_rate = step._slopes()
        for angle, rate in itertools.product((-0.9e-6, 0.9e-6), repeat=2):
            th, om = raw(start.th) + angle, raw(start.om) + rate
            with setting(terms=2):
                z, w = flint.arb_series([th, 1]), flint.arb_series([om, 1])
                along = contact.functions(arb(0), z, *z.sin_cos(), om), contact.functions(arb(0), th, *th.sin_cos(), w)
            for known, found in zip((by_angle, by_rate), along, strict=True):
                for ball_, one in zip(known, found, strict=True):
                    assert ball_.contains(models.padded(flint.arb_series([0]) + one, 2)[1].mid())


def test_errors_grow_at_least_as_the_equations_let_them():
    """About the unstable equilibrium a difference grows as e^(λ t), with the weight λ of θ."""
    case = Case("top", gravity=1.0, eccentricity=0.6, inertia_ratio=0.1, mu_static=9.0, mu_kinetic=9.0, vx=0.01, rolling=True)
    rate = math.sqrt(case.eccentricity / (case.inertia_ratio + 1.6**2))
    with setting(120):
        step = Step(phase(case, 2.0**-40)[0], None, arb(0.4))
        grown = step.error / (step.weight * arb(2) ** -40)
    assert math.exp(rate * float(step.h)) * 0.999 <= float(grown) < 1.6


@pytest.mark.parametrize("name", CASES)
def test_a_wrong_coefficient_is_in_the_error(name, monkeypatch):
    """The recurrences need not be right: what they leave of the equations counts."""
    wrong = arb(2) ** -40

    def rates(*given):
        found = models.rates(*given)
        return [*found[:3], found[3] + wrong, *found[4:]]

    monkeypatch.setattr(contact_module, "rates", rates)
    with setting(120):
        step = Step(phase(CASES[name])[0], None, arb(0.3))
    assert step.error >= 3 * wrong * step.h**3


@pytest.mark.parametrize("name", CASES)
def test_a_wrong_angle_is_in_the_error(name, monkeypatch):
    """What the polynomial for θ leaves of θ′ = h θ̇ counts with the weight of θ."""
    wrong = arb(2) ** -40

    def cut(values):
        p, lost = models.cut(values)
        return (p + arb_poly([0, 0, 0, wrong]) if float(values[0]) == CASES[name].angle else p), lost

    monkeypatch.setattr(contact_module, "cut", cut)
    with setting(120):
        step = Step(phase(CASES[name])[0], None, arb(0.3))
    assert step.error >= 3 * wrong * step.weight


@pytest.mark.parametrize("name", CASES)
def test_an_error_grows_by_the_logarithmic_norm(name):
    """Over a short step, by the eigenvalue of the symmetric part, as NumPy has it."""
    spread = 2.0**-40
    with setting(200):
        step = Step(phase(CASES[name], spread, spread)[0], None, arb(1e-5))
        (a, *_), (b, *_) = step._slopes()
        weight = float(step.weight)
        begin = ((step.weight * spread) ** 2 + arb(spread) ** 2).sqrt()
        growth = float((step.error / begin - 1) / step.h)
    across = 0.5 * (weight + float(a.mid()) / weight)
    norm = float(np.linalg.eigvalsh([[0.0, across], [across, float(b.mid())]])[-1])
    assert norm > 0.1
    assert growth == pytest.approx(norm, rel=1e-3, abs=1e-3)
    assert weight == pytest.approx(max(1.0, math.sqrt(abs(float(a.mid())))), rel=1e-12)


@pytest.mark.parametrize("name", CASES)
def test_what_a_model_bounds_is_in_the_error(name, monkeypatch):
    functions = Contact.functions

    def wide(self, tau, *given):
        alpha, *ends = functions(self, tau, *given)
        return [alpha + Model(arb_poly([0]), 1e-9) if isinstance(tau, Model) else alpha, *ends]

    monkeypatch.setattr(Contact, "functions", wide)
    with setting(120):
        step = Step(phase(CASES[name])[0], None, arb(0.3))
    assert step.error >= 1e-9 * step.h


@pytest.mark.parametrize("name", CASES)
def test_an_error_is_carried_from_step_to_step(name):
    """In the norm of the next step it is at least as large as before."""
    with setting(120):
        contact, _ = phase(CASES[name], 2.0**-40, 2.0**-40)
        first = Step(contact, None, arb(0.3))
        second = Step(contact, first, arb(0.3))
        third = Step(contact, second, arb(0.3))
        assert (second.tau, third.tau) == (first.h, first.h + second.h)
        assert (second.at(arb(0))[0], third.at(arb(0))[0]) == (first.h, first.h + second.h)
        assert second.error >= first.error * (second.weight / first.weight).max(arb(1)) * (1 - 2.0**-30)


def test_a_step_that_cannot_be_shown_is_halved_and_refused():
    with setting(60):
        contact, _ = phase(CASES["K"], 0.0, 1e-3)
        with pytest.raises(Unclear, match="small"):
            Step(contact, None, arb(0.3))


def test_a_step_is_halved_until_it_is_shown(monkeypatch):
    build, lengths = Step._build, []

    def third(self, th, series, h, error):
        build(self, th, series, h, error)
        lengths.append(float(h))
        return len(lengths) == 3

    monkeypatch.setattr(Step, "_build", third)
    with setting(120):
        Step(phase(CASES["R"])[0], None, arb(0.3))
    assert lengths == [lengths[0], lengths[0] / 2, lengths[0] / 4]


def test_the_first_of_two_events_in_a_step_is_found_or_unclear():
    def falling(*rates):
        models = [Model(arb_poly([1, -rate])) for rate in rates]
        return SimpleNamespace(models=models, taylor=lambda k, x, terms: [arb(0), arb(-rates[k])])

    with setting(60):
        k, x = Step.first_event(falling(2, 3), [0, 0], arb(1))
        assert (k, float(x)) == (1, pytest.approx(1 / 3))
        with pytest.raises(Unclear, match="first"):
            Step.first_event(falling(2, 2), [0, 0], arb(1))
