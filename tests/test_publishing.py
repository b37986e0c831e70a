"""What a release rests on: workflows, the recipe, the paper, the citation. Each says what pyproject.toml and the code say."""

import importlib.util
import re
import tomllib
from pathlib import Path

import pytest
import yaml

import hophoop
from hophoop.cite import references

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
WORKFLOWS = {path.stem: path for path in sorted((ROOT / ".github" / "workflows").glob("*.yml"))}


def read(*parts):
    return ROOT.joinpath(*parts).read_text(encoding="utf-8")


def workflow(name):
    """A workflow; YAML reads its key `on` as true."""
    return yaml.safe_load(WORKFLOWS[name].read_text(encoding="utf-8"))


def steps(name):
    return [step for job in workflow(name)["jobs"].values() for step in job["steps"]]


# Workflows


def test_tests_run_on_three_systems_with_every_python():
    matrix = workflow("tests")["jobs"]["wheel"]["strategy"]["matrix"]
    assert {system.partition("-")[0] for system in matrix["system"]} == {"ubuntu", "macos", "windows"}
    told = [name.rpartition(" ")[2] for name in PROJECT["classifiers"] if re.search(r":: 3\.\d+$", name)]
    assert matrix["python"] == told
    assert PROJECT["requires-python"] == f">={told[0]}"


@pytest.mark.parametrize("name", WORKFLOWS)
def test_a_workflow_asks_for_parts_that_are_there(name):
    script = read(".ci", "run")
    whole = re.search(r'^WHOLE="(.+)"$', script, re.MULTILINE)[1].split()
    for step in steps(name):
        for line in step.get("run", "").splitlines():
            if ".ci/run" in line:
                wanted = line.split(".ci/run")[1].split()
                assert wanted
                assert set(wanted) <= {*whole, "wheel"}, (name, wanted)


def test_every_part_of_the_check_runs_somewhere():
    asked = {
        part
        for name in WORKFLOWS
        for step in steps(name)
        for line in step.get("run", "").splitlines()
        if ".ci/run" in line
        for part in line.split(".ci/run")[1].split()
    }
    whole = re.search(r'^WHOLE="(.+)"$', read(".ci", "run"), re.MULTILINE)[1].split()
    assert asked == {*whole, "wheel"}


@pytest.mark.parametrize("name", WORKFLOWS)
def test_a_workflow_may_only_read_but_where_it_says_so(name):
    assert workflow(name)["permissions"] == {"contents": "read"}
    assert "secrets." not in WORKFLOWS[name].read_text(encoding="utf-8")


@pytest.mark.parametrize("name", WORKFLOWS)
def test_a_workflow_names_no_branch_and_no_tag_that_can_move(name):
    """Actions are pinned by the hash of a commit, with its release in a comment."""
    lines = [line for line in WORKFLOWS[name].read_text(encoding="utf-8").splitlines() if "uses:" in line]
    assert len(lines) == sum("uses" in step for step in steps(name))
    for line in lines:
        assert re.search(r"uses: [\w-]+/[\w-]+@[0-9a-f]{40}  # (v\d+\.\d+\.\d+|master, after v\d+\.\d+)$", line), line


def test_workflows_use_one_version_of_an_action():
    pins = {step["uses"] for name in WORKFLOWS for step in steps(name) if "uses" in step}
    assert len(pins) == len({pin.partition("@")[0] for pin in pins})


def test_a_release_is_published_without_a_password():
    jobs = workflow("release")["jobs"]
    publish = jobs["publish"]
    assert publish["permissions"] == {"id-token": "write"}
    assert publish["environment"] == "release"
    last = publish["steps"][-1]
    assert last["uses"].startswith("pypa/gh-action-pypi-publish@")
    assert "with" not in last
    assert publish["needs"] == "build"


def test_a_release_asks_for_lines_that_the_files_have():
    version = hophoop.__version__
    assert f'\n__version__ = "{version}"\n' in read("src", "hophoop", "_version.py")
    assert f'\nversion: "{version}"\n' in read("CITATION.cff")
    assert re.search(rf"^## {re.escape(version)} – (unreleased|\d{{4}}-\d\d-\d\d)$", read("CHANGELOG.md"), re.MULTILINE)


# The requirements


# The first version without a published weakness, and the smallest extra that brings the package.
@pytest.mark.parametrize(
    ("extra", "name", "first"),
    [
        ("plots", "pillow", "10.3"),
        ("plots", "jinja2", "3.1.6"),
        ("maps", "filelock", "3.20.1"),
        ("lab", "starlette", "0.49.1"),
        ("lab", "h11", "0.16"),
    ],
)
def test_no_extra_allows_a_version_with_a_known_weakness(extra, name, first):
    def numbers(version):
        return tuple(int(part) for part in version.split("."))

    (least,) = (one.removeprefix(f"{name}>=") for one in PROJECT["optional-dependencies"][extra] if one.startswith(f"{name}>="))
    assert numbers(least) >= numbers(first)


# The recipe


def test_the_recipe_has_the_requirements_of_the_package():
    text = re.sub(r"^\{%.*$", "", read("conda", "recipe", "meta.yaml"), flags=re.MULTILINE)
    recipe = yaml.safe_load(re.sub(r"\{\{ *(\w+) *\}\}", r"\1", text))
    told = {line.replace(" ", "") for line in recipe["requirements"]["run"]}
    assert told == {*PROJECT["dependencies"], f"python{PROJECT['requires-python']}"}
    assert f'version = "{hophoop.__version__}"' in read("conda", "recipe", "meta.yaml")
    assert recipe["about"]["summary"] == PROJECT["description"]
    (command,) = recipe["build"]["entry_points"]
    assert command == f"hophoop = {PROJECT['scripts']['hophoop']}"


# Paper and citation


def test_the_paper_has_what_the_journal_asks_for():
    _, front, text = read("paper", "paper.md").split("---", 2)
    told = yaml.safe_load(front)
    assert {"title", "tags", "authors", "affiliations", "date", "bibliography"} <= set(told)
    for heading in ("Summary", "Statement of need", "State of the field", "Software design", "Research impact statement"):
        assert f"\n# {heading}\n" in text
    assert 750 <= len(text.split()) <= 1750
    for figure in re.findall(r"\]\((\S+\.png)\)", text):
        assert (ROOT / "paper" / figure).exists()


def test_the_papers_works_are_those_of_the_documentation():
    spec = importlib.util.spec_from_file_location("make_bib", ROOT / "paper" / "make_bib.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert read("paper", "paper.bib") == module.bibliography()
    cited = set(re.findall(r"@(\w+)", read("paper", "paper.md").split("---", 2)[2]))
    assert cited <= set(references())
    assert len(cited) > 15


def test_the_citation_has_a_place_for_its_doi():
    text = read("CITATION.cff")
    told = yaml.safe_load(text)
    assert told["license"] == PROJECT["license"]
    assert "doi" in told or "\n# doi: " in text


def test_nothing_names_a_host_of_a_registry():
    files = [*WORKFLOWS.values(), ROOT / "conda" / "recipe" / "meta.yaml", ROOT / "paper" / "paper.md", ROOT / ".ci" / "run"]
    for path in files:
        assert not re.search(r"https?://", path.read_text(encoding="utf-8")), path.name
