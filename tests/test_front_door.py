"""What `import hophoop` offers, and what `simulate` takes."""

import json
import re
from pathlib import Path

import pytest

import hophoop as hh
from checkout import text_of
from kernel_tools import python

PARTS = {
    "plane": hh.Plane(mu=0.1),
    "start": hh.Start.rolling(2.0),
    "duration": 1.0,
    "contact": hh.Compliant(),
}


PAGE = text_of("docs/api.md")


# The names


def test_dir_shows_the_public_names_alone():
    code = """
import json
import hophoop as hh
before = dir(hh)
hh.simulate(hh.Scenario(duration=0.1)).at(0.05)
import hophoop.maps, hophoop.cli
print(json.dumps([before, dir(hh)]))
"""
    before, after = json.loads(python(code).stdout)
    assert before == after == sorted(hh.__all__)


def test_type_checkers_see_the_same_names():
    text = Path(hh.__file__).read_text(encoding="utf-8")
    seen = {name: module for module, name in re.findall(r"^    from (hophoop[\w.]*) import \w+ as (\w+)$", text, re.MULTILINE)}
    homes = {name: "hophoop" if home is None else f"hophoop.{home}" for name, home in hh._HOMES.items()}
    assert seen == homes


def test_the_reference_page_has_all_names():
    """That each can be imported as it says is Sphinx's to see."""
    names = re.findall(r"^   (hophoop\.[\w.]+)$", PAGE, re.MULTILINE)
    assert len(names) > 60
    assert {name.removeprefix("hophoop.") for name in names if name.count(".") == 1} == set(hh.__all__) - {"__version__"}


# simulate


@pytest.mark.parametrize("name", PARTS)
def test_a_scenario_takes_no_other_part(name):
    """It would be ignored, and the motion would be another one than was asked for."""
    with pytest.raises(ValueError, match=rf'^{name} cannot be given .*scenario\.with_values\({{"{name}": …}}\)'):
        hh.simulate(hh.Scenario(), **{name: PARTS[name]})
    assert getattr(hh.Scenario().with_values({name: PARTS[name]}), name) == PARTS[name]  # the advice works
    with pytest.raises(ValueError, match=f"^{name} cannot be given"):
        hh.simulate(hh.Scenario(), *[None] * list(PARTS).index(name), PARTS[name], digits=20)


def test_parts_have_their_defaults():
    still = hh.Start()
    assert hh.simulate(hh.Hoop()).scenario == hh.Scenario(start=still)
    assert hh.simulate(hh.Hoop(), duration=2.0).scenario == hh.Scenario(start=still, duration=2.0)
    assert hh.simulate(hh.Hoop(), hh.Plane(mu=0.5), hh.Start.rolling(2.0), 1.5, hh.Rigid()).duration == 1.5
