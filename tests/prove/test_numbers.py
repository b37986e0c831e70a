"""Balls, the copier of the kernel's functions, python-flint's settings and the clock: nothing uncertain passes."""

import math
import threading

import pytest

import hophoop as hh

flint = pytest.importorskip("flint")

from hophoop.prove import formulas, motion, numbers, prove, solver  # noqa: E402
from hophoop.prove.numbers import Ball, Unclear, arb  # noqa: E402

WIDE = Ball(arb(0, 1))
NAMES = ("__lt__", "__le__", "__gt__", "__ge__", "__eq__", "__ne__")


# --- comparisons ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_a_comparison_is_certain_or_raises(name):
    with pytest.raises(Unclear):
        getattr(WIDE, name)(Ball(0.5))
    for a, b in ((1.0, 2.0), (2.0, 1.0), (1.0, 1.0)):
        assert getattr(Ball(a), name)(Ball(b)) is getattr(a, name)(b)
        assert getattr(Ball(a), name)(b) is getattr(a, name)(b)
    assert getattr(WIDE, name)(WIDE) is getattr(1.0, name)(1.0)  # a number equals itself, wherever it is


@pytest.mark.parametrize("compute", [lambda: Ball(1) / WIDE, lambda: Ball(math.inf) * Ball(0), lambda: Ball(arb("nan"))])
def test_arithmetic_without_a_bounded_result_raises(compute):
    with pytest.raises(Unclear, match="bounded"):
        compute()


def test_only_a_nan_that_the_kernel_means_compares():
    for name in NAMES:
        assert getattr(Ball(math.nan), name)(Ball(1)) is (name == "__ne__")
    with pytest.raises(Unclear):
        Ball(math.nan) + 1


def test_a_number_is_true_where_it_is_certainly_not_zero():
    assert Ball(2)
    assert not Ball(0)
    with pytest.raises(Unclear):
        bool(WIDE)


# --- the copier -----------------------------------------------------------------------------------------------------------

CLOSENESS = 1e-6


def with_literal(x):
    return x < 3e-7


def with_tolerance(x):
    return x < CLOSENESS


def plain(x):
    return 0.5 * x < 1.0


@pytest.mark.parametrize(("function", "word"), [(with_literal, "3e-07"), (with_tolerance, "CLOSENESS")])
def test_the_copier_refuses_a_tolerance_that_is_not_named(function, word, monkeypatch):
    monkeypatch.setattr(formulas, "FORMULAS", (*formulas.FORMULAS, function))
    with pytest.raises(LookupError, match=word):
        prove(hh.Scenario(duration=0.1))


@pytest.mark.parametrize("name", sorted({*formulas.TOLERANCES, "is_last_bounce", "math", "sign_beyond", "write_event"}))
def test_a_renamed_global_of_the_kernel_is_not_overlooked(name, monkeypatch):
    """Under another name its replacement would be read by no function."""
    known = formulas.global_names
    monkeypatch.setattr(formulas, "global_names", lambda function: [one for one in known(function) if one != name])
    with pytest.raises(LookupError, match=name):
        prove(hh.Scenario(duration=0.1))


def test_a_literal_that_no_function_has_is_not_overlooked(monkeypatch):
    monkeypatch.setattr(formulas, "LITERALS", {*formulas.LITERALS, 1e-7})
    with pytest.raises(LookupError, match="1e-07"):
        prove(hh.Scenario(duration=0.1))


def test_exact_floats_are_accepted(monkeypatch):
    monkeypatch.setattr(formulas, "FORMULAS", (*formulas.FORMULAS, plain))
    assert prove(hh.Scenario(duration=0.1)).proved


# --- an undecided comparison in each copied function ----------------------------------------------------------------------

BOUNCE = hh.Plane(restitution=0.3)
MOTIONS = {
    "hop": hh.Scenario(duration=2.0),
    "bounce": hh.Scenario(plane=BOUNCE, start=hh.Start(height=0.1, omega=2.0, vx=1.0), duration=1.0),
    "resisted": hh.Scenario(plane=hh.Plane(mu=0.1, rolling_resistance=0.05), start=hh.Start(vx=1.0, omega=0.5), duration=2.0),
    "smooth": hh.Scenario.from_query("duration=0.5&plane.mu=0&start.angle=1&start.omega=1"),
    "rest": hh.Scenario(plane=hh.Plane(rolling_resistance=0.3), start=hh.Start(vx=0.0, omega=0.0, angle=0.1), duration=0.5),
    "paradox": hh.Scenario.from_query("duration=0.1&plane.mu=1.2&start.angle=-0.7&start.vx=3&start.omega=1"),
    "slides": hh.Scenario.from_query("duration=0.1&hoop.load_fraction=0&plane.mu=0.1&start.vx=1"),
}


def compare_in(monkeypatch, meet):
    """Let `meet` see the names of the functions that compare balls."""
    for name in NAMES:
        compare = getattr(Ball, name)

        def watched(self, other, compare=compare):
            meet(numbers_frame())
            return compare(self, other)

        monkeypatch.setattr(Ball, name, watched)


def numbers_frame():
    """The copied function that compares, '' elsewhere."""
    import sys

    frame = sys._getframe(3)
    return frame.f_code.co_name if "/hophoop/kernel/" in frame.f_code.co_filename.replace("\\", "/") else ""


@pytest.mark.parametrize("name", MOTIONS)
def test_an_undecided_comparison_in_any_copied_function_leaves_the_motion_undecided(name, monkeypatch):
    monkeypatch.setattr(solver, "TRIES", 1)
    seen = set()
    with monkeypatch.context() as patched:
        compare_in(patched, seen.add)
        prove(MOTIONS[name], 8)
    assert len(seen - {""}) > 3
    for target in sorted(seen - {""}):

        def meet(where, target=target):
            if where == target:
                raise Unclear(f"{target} decides")

        with monkeypatch.context() as patched:
            compare_in(patched, meet)
            found = prove(MOTIONS[name], 8)
        assert (found.verdict, found.why) == ("undecided", f"it cannot be shown that {target} decides")


# --- ends of bounces, exact zeros -----------------------------------------------------------------------------------------


def test_nothing_ends_bounces_but_a_bound_on_all_later_ones(monkeypatch):
    """Later bounces, which extended precision computes, lie within what the last event of the bounces states."""
    scenario = hh.Scenario(plane=BOUNCE, start=hh.Start(height=0.5, vx=1.0, omega=3.0, vy=2.0), duration=2.0)
    found, later = prove(scenario, 8), hh.simulate(scenario, digits=40)
    place = next(k for k, event in enumerate(found.events) if event.kind == "bounce_limit")
    assert later.events[place].kind == "impact"
    limit = found.events[place]
    for event in later.events[place + 2 :]:
        if event.kind not in ("impact", "bounce_limit"):
            break
        for name in ("t", "x", "angle", "omega"):
            assert getattr(limit, name).holds(getattr(event, name)), (event.t, name)
    monkeypatch.setattr(motion.Run, "after_bounces", lambda self, after: None)
    monkeypatch.setattr(solver, "TRIES", 1)
    endless = prove(scenario, 8)
    assert (endless.verdict, "bounce_limit" in [event.kind for event in endless.events]) == ("undecided", False)


def test_bounces_on_infinite_friction_are_undecided_with_a_reason():
    scenario = hh.Scenario.from_query("duration=3&plane.mu=inf&plane.restitution=0.5&start.height=0.5&start.omega=2")
    found = prove(scenario, 8, seconds=0.5)
    assert found.verdict == "undecided"
    assert found.why


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_vertical_drop_ends_at_rest(restitution):
    """v_t, θ and θ̇ are exactly zero all the way."""
    plane = hh.Plane(mu=0.2, restitution=restitution)
    found = prove(hh.Scenario(plane=plane, start=hh.Start(height=0.5), duration=4.0), 15)
    assert (found.verdict, found.status) == ("proved", "at_rest")
    assert all(one.middle == one.radius == 0 for event in found.events for one in (event.angle, event.omega, event.slip))


# --- settings -------------------------------------------------------------------------------------------------------------


def test_threads_of_different_precision_do_not_disturb_each_other():
    flint.ctx.prec, flint.ctx.cap = 77, 13
    scenario = hh.Scenario(duration=0.5)
    alone = {digits: prove(scenario, digits).to_dict() for digits in (15, 50)}
    found = {}

    def work(k, digits):
        found[k, digits] = prove(scenario, digits).to_dict()

    threads = [threading.Thread(target=work, args=(k, (15, 50)[k % 2])) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(result == alone[digits] for (_, digits), result in found.items())
    assert len(found) == 8
    assert (flint.ctx.prec, flint.ctx.cap) == (77, 13)


def test_settings_are_as_before_after_an_interruption():
    flint.ctx.prec, flint.ctx.cap = 77, 13

    def interrupt():
        raise KeyboardInterrupt

    scenario = hh.Scenario(duration=2.0)
    with pytest.raises(KeyboardInterrupt):
        solver.prove_problem(scenario, solver.Problem.of(scenario), 15, "duration", 100, interrupt)
    assert (flint.ctx.prec, flint.ctx.cap) == (77, 13)
    assert numbers.LOCK.acquire(blocking=False)
    numbers.LOCK.release()


# --- the clock ------------------------------------------------------------------------------------------------------------

# slip, rolling and a hop; bounces; rolling with resistance; slip with turning points
CLOCKED = {name: MOTIONS[name] for name in ("hop", "bounce", "resisted")} | {
    "rocking": hh.Scenario.from_query("duration=3&plane.mu=0.1&start.angle=2&start.vx=-1&start.omega=1.5")
}


def proved(scenario, looks):
    """The proof of a motion whose time is over after so many looks at the clock, and how many there were."""
    count = 0

    def late():
        nonlocal count
        count += 1
        return count > looks

    return solver.prove_problem(scenario, solver.Problem.of(scenario), 8, "duration", 4000, late), count


@pytest.mark.parametrize("name", CLOCKED)
def test_a_proof_ends_wherever_its_time_is_over(name):
    """The clock is asked between all steps."""
    whole, looks = proved(CLOCKED[name], 10**9)
    assert whole.proved
    assert looks > 5
    for most in (0, 1, 5, *range(10, looks, max(1, looks // 6))):
        found, count = proved(CLOCKED[name], most)
        assert count == most + 1
        assert (found.verdict, found.why) == ("undecided", solver.LATE)
        assert found.events == whole.events[: len(found.events)]
