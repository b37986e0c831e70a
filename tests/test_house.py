"""The rules of the house that no linter knows: imports, extras, docstrings."""

import functools
import importlib
import inspect
import re
import tomllib
from importlib.metadata import packages_distributions

import numpydoc.docscrape
import numpydoc.validate
import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import hophoop
from checkout import ROOT, text_of
from hophoop._support import extras
from kernel_tools import python

SOURCE = ROOT / "src" / "hophoop"
NEED = re.compile(r'\bneed\(\s*"([\w.]+)",\s*"(\w+)"')
PROJECT = tomllib.loads(text_of("pyproject.toml"))["project"]


def said_by(code):
    """Output of a program that must succeed."""
    done = python(code)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_changelog_has_this_version():
    assert f"\n## {hophoop.__version__}" in text_of("CHANGELOG.md")


# What an import costs, and what a missing extra says

CORE = {"numpy", "pydantic"}

LOADED = """
import sys
before = set(sys.modules)
{code}
names = {{name.partition('.')[0] for name in set(sys.modules) - before}}
print(*sorted(names - sys.stdlib_module_names))
"""


def loaded_by(code):
    """Top-level modules outside the standard library that an import brings with it."""
    found = set(said_by(LOADED.format(code=code)).split())
    # of the standard library as well, under names that it does not list
    return {name for name in found if name != "__mp_main__" and not name.startswith("_sysconfigdata")}


def test_import_budget():
    # NumPy and pydantic may bring what they like.
    core = loaded_by(f"import annotated_types, {', '.join(sorted(CORE))}")
    assert loaded_by("import hophoop; hophoop.simulate; hophoop.Trajectory; hophoop.theory") - core == {"hophoop"}
    assert loaded_by("import hophoop; hophoop.Scenario().to_query()") - core == {"hophoop"}


WITHOUT = """
import importlib, pkgutil, sys

class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition('.')[0] in {absent!r}:
            raise ModuleNotFoundError(f'No module named {{name!r}}', name=name)

sys.meta_path.insert(0, Absent())
{code}
"""


def extra_modules(extra):
    """Modules that an extra installs, with those of the extras it includes; of one that is missing the module of its name."""
    found = set()
    for requirement in map(Requirement, PROJECT["optional-dependencies"][extra]):
        if requirement.name == "hophoop":
            found |= {module for other in requirement.extras for module in extra_modules(other)}
            continue
        names = [module for module, packages in owners().items() if canonicalize_name(requirement.name) in packages]
        found |= set(names or [requirement.name.replace("-", "_")])
    return found


@functools.cache
def owners():
    """Packages that install each module here."""
    return {module: set(map(canonicalize_name, names)) for module, names in packages_distributions().items()}


def test_every_module_imports_without_the_extras():
    # The lab is written on FastAPI throughout; its modules are loaded by `hophoop lab` alone. These are written on Numba:
    on_numba = ["hophoop.kernel.build."]
    on_numba += [f"hophoop.lab.wasm.{name}" for name in ("answers", "compliant", "derivatives", "entries", "motions")]
    absent = set().union(*map(extra_modules, PROJECT["optional-dependencies"]))
    code = f"""
import hophoop
for module in pkgutil.walk_packages(hophoop.__path__, 'hophoop.', onerror=lambda name: None):
    if not module.name.startswith(('hophoop.lab.', *{on_numba})) and not module.name.endswith('__main__'):
        importlib.import_module(module.name)
"""
    said_by(WITHOUT.format(absent=absent, code=code))


def test_extras_hold_what_is_needed_of_them():
    """Every `need(module, extra)` in the source takes two plain strings."""
    calls = [found for path in SOURCE.rglob("*.py") for found in NEED.findall(path.read_text(encoding="utf-8"))]
    assert len(calls) > 30
    for module, extra in set(calls):
        if not module.startswith("hophoop."):  # packages of our own need no installing
            assert module.partition(".")[0] in extra_modules(extra), f"{module} is not in {extra}"


def test_a_missing_extra_is_named():
    code = """
from hophoop._support.extras import need
try:
    need('matplotlib.pyplot', 'plots')
except ImportError as error:
    print(error)
"""
    said = said_by(WITHOUT.format(absent={"matplotlib"}, code=code)).strip()
    assert said == f"matplotlib is not installed; it comes with the extra 'plots': pip install -e \"{ROOT}[plots]\"."


def test_an_extra_of_an_installed_wheel_is_its_libraries(monkeypatch, tmp_path):
    """Anyone could put a package named hophoop into an index."""
    monkeypatch.setattr(extras, "CHECKOUT", tmp_path)
    required = [
        "numpy>=2", "hophoop[plots]; extra == 'films'", "av>=15 ; extra == 'films'", "pillow>=10 ; extra == 'plots'",
        'matplotlib>=3.10; extra == "plots"', "pillow>=10 ; extra == 'films'",
    ]  # fmt: skip
    monkeypatch.setattr(extras, "requires", lambda name: required)
    assert extras.install_command("films") == 'pip install "pillow>=10" "matplotlib>=3.10" "av>=15"'
    assert extras.install_command("plots") == 'pip install "pillow>=10" "matplotlib>=3.10"'
    assert extras.install_command("none") == ""
    monkeypatch.setattr(extras, "requires", lambda name: None)
    assert extras.install_command("plots") == ""
    with pytest.raises(extras.MissingExtra, match=r"^nothing_at_all is not installed; it comes with the extra 'plots'\.$"):
        extras.need("nothing_at_all", "plots")


def test_a_folder_with_spaces_and_signs_is_quoted(monkeypatch, tmp_path):
    for name, quoted in (("my hoops", '"{}[fit]"'), ("co$t", "'{}[fit]'")):
        checkout = tmp_path / name
        (checkout / "src" / "hophoop").mkdir(parents=True)
        (checkout / "pyproject.toml").touch()
        monkeypatch.setattr(extras, "CHECKOUT", checkout)
        assert extras.install_command("fit") == f"pip install -e {quoted.format(checkout)}"


# Public names and their docstrings


# The packages whose functions users call; kernels are documented by physics formulas beside the code.
ROOMS = [
    "scenario", "simulation.simulate", "simulation.trajectory", "theory", "io", "results.save", "results.notebook",
    "results.poses", "cite", "maps", "plots", "animate", "article", "lab", "precise", "prove", "tracking", "fitting",
]  # fmt: skip


def public_names(room):
    """Dotted names of the functions, classes and methods of a room that a user meets."""
    module = importlib.import_module(f"hophoop.{room}")
    own = [name for name, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__]
    for name in getattr(module, "__all__", own):
        value = getattr(module, name)
        if not name.startswith("_") and (inspect.isfunction(value) or inspect.isclass(value)):
            yield f"hophoop.{room}.{name}"
            for method, member in vars(value).items() if inspect.isclass(value) else ():
                if not method.startswith("_") and (inspect.isroutine(member) or isinstance(member, property | classmethod)):
                    yield f"hophoop.{room}.{name}.{method}"


NUMERIC = re.compile(r"(?!.*\bstr\b).*\b(float|array_like|ndarray)\b")
UNIT = re.compile(r"\[[^\[\]]+\]")
# of numpydoc: no docstring, unknown parameters, no Returns, a first line that is no sentence
CODES = {"GL08", "PR02", "RT01", "SS03"}


def complaints(name):
    """What is missing in a docstring: what numpydoc finds, a parameter, a unit."""
    checked = numpydoc.validate.Validator(numpydoc.docscrape.get_doc_object(numpydoc.validate.Validator._load_obj(name)))
    codes = CODES | ({"PR01"} if inspect.isroutine(checked.obj) else set())
    found = [f"{code}: {words}" for code, words in numpydoc.validate.validate(name)["errors"] if code in codes]
    for part in ("Parameters", "Returns", "Yields"):
        for entry in checked.doc[part]:
            if NUMERIC.search(entry.type) and not UNIT.search(" ".join([entry.type, *entry.desc])):
                found.append(f"no unit for {entry.name or part}")
    return found


def test_docstrings_are_whole():
    names = [name for room in ROOMS for name in public_names(room)]
    assert len(names) > 200
    assert {name: found for name in names if (found := complaints(name))} == {}
