"""What a motion is read as: units, words, samples and the table of events."""

import pytest

import hophoop as hh
from hophoop.export import EVENT_UNITS
from hophoop.results import Ledger
from hophoop.units import Units


def test_a_quantity_has_its_unit():
    units = Units(length=2.0, time=0.5, mass=3.0)
    sizes = {"height": 2.0, "vy": 4.0, "omega": 2.0, "angle": 1.0, "normal_force": 24.0, "impulse_normal": 12.0, "gain": 48.0}
    assert {name: units.of(name) for name in sizes} == sizes


@pytest.mark.parametrize("name", ["heigth", "", "t", "energy", "before_vx", "residuals"])
def test_another_name_has_none(name):
    """It was an energy."""
    units = hh.simulate(hh.Scenario(duration=0.1)).units
    with pytest.raises(ValueError, match="^'" + name + "' has no unit: the quantities are x, height, vx, "):
        units.of(name)


def test_all_numbers_of_events_and_ledgers_have_one():
    units = Units(1.0, 1.0, 1.0)
    names = {name.removeprefix("before_") for name in EVENT_UNITS} - {"t"}
    names |= set(Ledger.__dataclass_fields__) - {"residual", "range"}
    assert {name: units.of(name) for name in names} == dict.fromkeys(names, 1.0)
