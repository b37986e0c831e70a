"""What `import hophoop` offers, and what `simulate` takes."""

import ast
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import hophoop as hh

PARTS = {
    "plane": hh.Plane(mu=0.1),
    "start": hh.Start.rolling(2.0),
    "duration": 1.0,
    "contact": hh.Compliant(),
}


ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")


def said_by(code, *arguments):
    """What a fresh interpreter prints, as JSON."""
    done = subprocess.run([sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


# The names


def test_dir_shows_the_public_names_alone():
    before, after = said_by("""
import json
import hophoop as hh
before = dir(hh)
hh.simulate(hh.Scenario(duration=0.1)).at(0.05)
import hophoop.maps, hophoop.cli
print(json.dumps([before, dir(hh)]))
""")
    assert before == after == sorted(hh.__all__)
    assert {"simulate", "io", "cite", "__version__"} <= set(before)
    assert not {"Any", "TYPE_CHECKING", "import_module", "annotations"} & set(before)


def test_type_checkers_see_the_same_names():
    tree = ast.parse(Path(hh.__file__).read_text(encoding="utf-8"))
    (block,) = (node for node in tree.body if isinstance(node, ast.If) and getattr(node.test, "id", "") == "TYPE_CHECKING")
    seen = {}
    for node in block.body:
        assert isinstance(node, ast.ImportFrom), ast.unparse(node)
        (name,) = node.names
        assert name.asname == name.name, "an import without 'as' is not exported"
        seen[name.name] = None if node.module == "hophoop" else node.module.removeprefix("hophoop.")
    assert seen == hh._HOMES


IMPORTED = """
import json, sys
wrong = {}
for names in json.loads(sys.argv[1]):
    for loaded in [each for each in sys.modules if each.partition(".")[0] == "hophoop"]:
        del sys.modules[loaded]
    for name in names:
        module, _, last = name.rpartition(".")
        try:
            if module == "hophoop":
                import hophoop as hh
                getattr(hh, last)
            else:
                exec(f"from {module} import {last}")
        except Exception as error:
            wrong[name] = repr(error)
print(json.dumps(wrong))
"""


def test_names_of_the_reference_page_are_imported_as_it_says():
    names = re.findall(r"^   (hophoop\.[\w.]+)$", PAGE, re.MULTILINE)
    assert len(names) > 60
    one_dot = {name.removeprefix("hophoop.") for name in names if name.count(".") == 1}
    assert one_dot == set(hh.__all__) - {"__version__"}
    groups = {}  # the names of one module share an import, which starts without any module of hophoop
    for name in names:
        module, _, last = name.rpartition(".")
        groups.setdefault((module, hh._HOMES[last] or last) if module == "hophoop" else module, []).append(name)
    wrong = ["hophoop.simulat", "hophoop.results.records.Sampel"]
    assert said_by(IMPORTED, json.dumps([*groups.values(), wrong])).keys() == set(wrong)


# simulate


@pytest.mark.parametrize("name", PARTS)
def test_a_scenario_takes_no_other_part(name):
    """It would be ignored, and the motion would be another one than was asked for."""
    with pytest.raises(ValueError, match=rf'^{name} cannot be given .*scenario\.with_values\({{"{name}": …}}\)') as refused:
        hh.simulate(hh.Scenario(), **{name: PARTS[name]})
    assert isinstance(refused.value, hh.scenario.InputError)
    position = list(PARTS).index(name)
    with pytest.raises(ValueError, match=f"^{name} cannot be given"):
        hh.simulate(hh.Scenario(), *[None] * position, PARTS[name])
    with pytest.raises(ValueError, match=f"^{name} cannot be given"):
        hh.simulate(hh.Scenario(), digits=20, **{name: PARTS[name]})


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
