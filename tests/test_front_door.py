"""What `import hophoop` offers, and what `simulate` takes."""

import pytest

import hophoop as hh

PARTS = {
    "plane": hh.Plane(mu=0.1),
    "start": hh.Start.rolling(2.0),
    "duration": 1.0,
    "contact": hh.Compliant(),
}


# simulate


@pytest.mark.parametrize("name", PARTS)
def test_a_scenario_takes_no_other_part(name):
    """It would be ignored, and the motion would be another one than was asked for."""
    with pytest.raises(ValueError, match=rf'^{name} is part of .*scenario\.replace\("{name}", …\)') as refused:
        hh.simulate(hh.Scenario(), **{name: PARTS[name]})
    assert isinstance(refused.value, hh.scenario.InputError)
    position = list(PARTS).index(name)
    with pytest.raises(ValueError, match=f"^{name} is part of"):
        hh.simulate(hh.Scenario(), *[None] * position, PARTS[name])
    with pytest.raises(ValueError, match=f"^{name} is part of"):
        hh.simulate(hh.Scenario(), digits=20, **{name: PARTS[name]})


def test_all_parts_are_named():
    with pytest.raises(
        ValueError, match=r'^plane, start and duration are .*with_values\({"plane": …, "start": …, "duration": …}\)'
    ):
        hh.simulate(hh.Scenario(), hh.Plane(), hh.Start(), 6.0)


def test_the_advice_works():
    scenario = hh.Scenario()
    for name, part in PARTS.items():
        changed = scenario.replace(name, part)
        assert getattr(changed, name) == part
    changed = scenario.with_values(dict(PARTS))
    assert {name: getattr(changed, name) for name in PARTS} == PARTS


def test_parts_have_their_defaults():
    still = hh.Start()
    assert hh.simulate(hh.Hoop()).scenario == hh.Scenario(start=still)
    assert hh.simulate(hh.Hoop(), duration=2.0).scenario == hh.Scenario(start=still, duration=2.0)
    assert hh.simulate(hh.Hoop(), hh.Plane(mu=0.5), hh.Start.rolling(2.0), 1.5, hh.Rigid()).duration == 1.5
