"""The rules of the house that no linter knows: imports, extras, docstrings, citations."""

import ast
import functools
import gc
import importlib
import inspect
import re
import subprocess
import sys
import tomllib
import warnings
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest
from numpydoc.docscrape import ClassDoc, FunctionDoc
from packaging.requirements import Requirement
from pydantic import BaseModel

import hophoop
from hophoop._support import extras

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "hophoop"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def run(*command):
    """Output of a command that must succeed."""
    done = subprocess.run([str(part) for part in command], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def python(code):
    return run(sys.executable, "-c", code)


def test_only_collecting_tests_leaves_cycles_where_they_are():
    assert gc.isenabled()
    assert gc.get_freeze_count() > 0


def test_one_version():
    version = hophoop.__version__
    assert f'\nversion: "{version}"\n' in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\n## {version}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


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
    found = set(python(LOADED.format(code=code)).split())
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


@functools.cache
def distributions_of_modules():
    """Which distributions hold each top-level module; it takes a quarter of a second to find out."""
    return packages_distributions()


def import_names(requirements):
    """Top-level modules of these distributions; of one that is not installed the module of its name."""
    wanted = {re.sub(r"[-_.]+", "-", Requirement(line).name).lower() for line in requirements}
    found, installed = set(), set()
    for module, distributions in distributions_of_modules().items():
        here = wanted & {re.sub(r"[-_.]+", "-", name).lower() for name in distributions}
        if here:
            found.add(module)
            installed |= here
    return found | {name.replace("-", "_") for name in wanted - installed}


def extra_modules(extra):
    """Modules that an extra installs, with those of the extras it includes."""
    found = set()
    for line in PROJECT["optional-dependencies"][extra]:
        requirement = Requirement(line)
        if requirement.name == "hophoop":
            found |= {module for other in requirement.extras for module in extra_modules(other)}
        else:
            found |= import_names([line])
    return found


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
    python(WITHOUT.format(absent=absent, code=code))


def needs():
    """Every `need(module, extra)` in the source."""
    for path in sorted(SOURCE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "need":
                values = [argument.value for argument in node.args if isinstance(argument, ast.Constant)]
                assert len(values) == 2, f"{path}:{node.lineno}: need() takes two plain strings"
                yield f"{path.relative_to(SOURCE)}:{node.lineno}", *values


def test_extras_hold_what_is_needed_of_them():
    for place, module, extra in needs():
        assert extra in PROJECT["optional-dependencies"], place
        if not module.startswith("hophoop."):  # rooms of our own need no installing
            assert module.partition(".")[0] in extra_modules(extra), f"{place}: {module} is not in {extra}"


def test_a_missing_extra_is_named():
    code = """
from hophoop._support.extras import need
try:
    need('matplotlib.pyplot', 'plots')
except ImportError as error:
    print(error)
"""
    said = python(WITHOUT.format(absent={"matplotlib"}, code=code)).strip()
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
    for extra in PROJECT["optional-dependencies"]:  # as the metadata of this project has them
        found = extras._libraries(extra, [f"{one}; extra == '{extra}'" for one in PROJECT["optional-dependencies"][extra]])
        assert found or all(one.startswith("hophoop[") for one in PROJECT["optional-dependencies"][extra])
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


def test_no_text_names_the_package_in_an_index():
    sources = [*(ROOT / "src").rglob("*.py"), *(ROOT / "src/hophoop/lab/words").glob("*.json")]
    assert [file for file in sources if re.search(r"pip install \W*hophoop", file.read_text(encoding="utf-8"))] == []


# Public names and their docstrings


@pytest.mark.parametrize("name", hophoop.__all__)
def test_public_names_are_there(name):
    assert getattr(hophoop, name) is not None
    assert name in dir(hophoop)
    if name != "__version__":
        assert f"hophoop.{name}\n" in (ROOT / "docs" / "api.md").read_text(encoding="utf-8"), "not in docs/api.md"


def test_unknown_names_are_not():
    with pytest.raises(AttributeError, match="no attribute 'simulat'"):
        _ = hophoop.simulat


# The rooms whose functions users call; kernels are documented by physics formulas beside the code.
ROOMS = ["scenario", "simulation.simulate", "simulation.trajectory", "theory", "io"]
ROOMS += ["results.save", "results.notebook", "results.poses"]
ROOMS += [
    "cite",
    "maps",
    "plots",
    "animate",
    "article",
    "lab",
    "precise",
    "prove",
    "tracking",
    "fitting",
]


def public_objects(room):
    """Functions and classes of a room that a user meets, by their dotted name."""
    module = importlib.import_module(f"hophoop.{room}")
    own = [name for name, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__]
    found = {}
    for name in getattr(module, "__all__", own):
        value = getattr(module, name)
        if name.startswith("_") or not (inspect.isfunction(value) or inspect.isclass(value)):
            continue
        found[name] = value
        if inspect.isclass(value):
            found |= {f"{name}.{method}": member for method, member in own_members(value)}
    return found


def is_from(value, module):
    return (getattr(value, "__module__", None) or "").startswith(module)


def own_members(cls):
    for name, member in vars(cls).items():
        if name.startswith("_"):
            continue
        if isinstance(member, classmethod | staticmethod):
            member = member.__func__
        if inspect.isfunction(member) or isinstance(member, property):
            yield name, member


NUMERIC = re.compile(r"\b(float|ArrayLike|NDArray|ndarray|Array)\b")
UNIT = re.compile(r"\[[^\[\]]+\]")
CITED = re.compile(r"(?::cite(?::\w+)?:|\{cite(?::\w+)?\})`([^`]+)`")


def parsed(text, cls=None):
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # an unknown or doubled section
        return ClassDoc(None, doc=text) if cls else FunctionDoc(None, doc=text)


def section(doc, title):
    """Names of a numpydoc section and the text that stands with each."""
    entries = {}
    for entry in doc[title]:
        text = " ".join([entry.type, *entry.desc])
        for name in (entry.name or "").split(","):
            entries[name.strip().lstrip("*")] = text
    return entries


def parameters(value):
    """Names and annotations, as text, of what a function or class is called with."""
    if inspect.isclass(value) and issubclass(value, BaseModel):
        # A word that can be said in one way only is no choice.
        fields = {name: str(field.annotation) for name, field in value.model_fields.items()}
        return {name: note for name, note in fields.items() if not re.fullmatch(r"typing\.Literal\['\w+'\]", note)}
    found = {}
    for name, parameter in inspect.signature(value).parameters.items():
        if name not in ("self", "cls") and parameter.kind is not parameter.VAR_KEYWORD:
            found[name] = str(parameter.annotation)
    return found


def raises_itself(value):
    """Whether a function's own lines raise something new."""
    tree = ast.parse(inspect.cleandoc("\n" + inspect.getsource(value)))
    return any(isinstance(node, ast.Raise) and node.exc is not None for node in ast.walk(tree))


def complaints(value):
    """What is missing in a docstring."""
    text = inspect.getdoc(value.fget if isinstance(value, property) else value)
    if not text:
        return ["no docstring"]
    found = []
    if not text.splitlines()[0].endswith((".", ":", "?")):
        found.append("the first line is not a sentence")
    found += [f"unknown reference {key}" for key in cited(text) - REFERENCES]
    if isinstance(value, property):
        if NUMERIC.search(str(inspect.signature(value.fget).return_annotation)) and not UNIT.search(text):
            found.append("no unit")
        return found
    is_class = inspect.isclass(value)
    if is_class and value.__mro__[1] is not object and not issubclass(value, BaseModel | tuple):
        return found  # enumerations, exceptions
    try:
        doc = parsed(text, is_class)
    except (Warning, ValueError) as problem:
        return [*found, str(problem)]
    expected = parameters(value)
    named = section(doc, "Parameters") or (section(doc, "Attributes") if is_class else {})
    if is_class and not named and not issubclass(value, BaseModel | tuple):
        return found  # a result, which users do not build
    if set(named) != set(expected):
        found.append(f"parameters {sorted(expected)} are documented as {sorted(named)}")
    for name, note in expected.items():
        if NUMERIC.search(note) and not UNIT.search(named.get(name, "[]")):
            found.append(f"no unit for {name}")
    if not is_class:
        found += complaints_about_results(value, doc)
    if doc["References"] and not cited("\n".join(doc["References"])):
        found.append("References name no key of docs/references.bib")
    return found


def complaints_about_results(function, doc):
    note = str(inspect.signature(function).return_annotation)
    if note not in ("None", "<class 'inspect._empty'>", str(inspect.Signature.empty)):
        results = " ".join(line for part in ("Returns", "Yields") for entry in doc[part] for line in entry.desc)
        if not (doc["Returns"] or doc["Yields"]):
            yield "no Returns"
        elif NUMERIC.search(note) and not UNIT.search(results):
            yield "no unit in Returns"
    if raises_itself(function) and not doc["Raises"]:
        yield "no Raises"


def cited(text):
    return {key.strip() for keys in CITED.findall(text) for key in keys.split(",")}


REFERENCES = set(re.findall(r"^@\w+\{(\w+),", (ROOT / "docs" / "references.bib").read_text(encoding="utf-8"), re.MULTILINE))


@pytest.mark.parametrize("room", [room for room in ROOMS if any(SOURCE.glob(f"{room.replace('.', '/')}*"))])
def test_docstrings_are_whole(room):
    objects = public_objects(room)
    assert objects, f"hophoop.{room} names nothing public: give it an __all__"
    assert {name: found for name, value in objects.items() if (found := complaints(value))} == {}


def test_pages_cite_what_there_is():
    for page in sorted((ROOT / "docs").rglob("*.md")):
        assert cited(page.read_text(encoding="utf-8")) <= REFERENCES, page.name


# The walk itself: a docstring that lacks something must fail


def whole(speed: float) -> float:
    """Twice the speed, after :cite:t:`Littlewood1953`.

    Parameters
    ----------
    speed : float
        A speed [m/s].

    Returns
    -------
    twice : float
        Another [m/s].

    Raises
    ------
    ValueError
        If speed is negative.
    """
    if speed < 0:
        raise ValueError(speed)
    return 2 * speed


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("", "", []),
        ("speed [m/s].", "speed.", ["no unit for speed"]),
        ("Another [m/s].", "Another.", ["no unit in Returns"]),
        (
            "speed : float",
            "pace : float",
            ["parameters ['speed'] are documented as ['pace']", "no unit for speed"],
        ),
        ("Littlewood1953", "Littlewood1593", ["unknown reference Littlewood1593"]),
        ("Raises\n------", "Notes\n-----", ["no Raises"]),
        ("Returns\n-------\ntwice : float\n    Another [m/s].\n\n", "", ["no Returns"]),
    ],
)
def test_the_walk_notices(monkeypatch, old, new, expected):
    monkeypatch.setattr(whole, "__doc__", inspect.getdoc(whole).replace(old, new) if old else whole.__doc__)
    assert complaints(whole) == expected


# Sections that the source cites

CITED_SECTION = re.compile(r"\bdocs/([\w-]+\.md)(?:#([\w-]+))?")


def anchors(page):
    """Anchors of a page's headings, as the documentation's builder makes them."""
    lines = (ROOT / "docs" / page).read_text(encoding="utf-8").splitlines()
    titles = [line.lstrip("#").strip() for line in lines if re.match(r"#{1,3} ", line)]
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def cited_sections():
    for folder in (SOURCE, ROOT / "tests"):
        for path in sorted(folder.rglob("*.py")):
            for found in CITED_SECTION.finditer(path.read_text(encoding="utf-8")):
                yield path.relative_to(ROOT).as_posix(), found[1], found[2]


def test_cited_sections_are_there():
    places = list(cited_sections())
    assert len({place for place, page, anchor in places if anchor}) > 6
    for place, page, anchor in places:
        assert (ROOT / "docs" / page).exists(), f"{place}: docs/{page}"
        assert anchor is None or anchor in anchors(page), f"{place}: docs/{page}#{anchor}"


PHYSICS = {path.stem for path in (SOURCE / "kernel" / "physics").glob("[a-z]*.py")} - {"ranges"}  # which has no formula


@pytest.mark.parametrize("module", sorted(PHYSICS))
def test_every_module_of_physics_cites_its_section_of_the_model(module):
    """In its docstring, where a reader looks for the derivation."""
    source = (SOURCE / "kernel" / "physics" / f"{module}.py").read_text(encoding="utf-8")
    sections = {found[2] for found in CITED_SECTION.finditer(ast.get_docstring(ast.parse(source))) if found[1] == "model.md"}
    assert sections - {None}
    assert sections <= anchors("model.md")


def test_every_section_of_the_model_is_cited_by_code():
    cited = {anchor for place, page, anchor in cited_sections() if page == "model.md" and place.startswith("src")}
    sections = re.findall(r"^## (.*)$", (ROOT / "docs" / "model.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert len(sections) > 10
    assert {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in sections} <= cited


def test_nothing_outside_the_repository_is_cited():
    missing = "physics" + ".md"
    for folder in ("src", "tests", "docs", "examples", "benchmarks"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix in (".py", ".md", ".js"):
                assert missing not in path.read_text(encoding="utf-8"), path.relative_to(ROOT)
