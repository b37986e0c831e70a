"""Runs what a page of the documentation shows: code, commands, and the numbers in its text.

From top to bottom, in one namespace a page:

- a block ``pycon`` is a doctest, a block ``python`` is run;
- a block ``toml`` is a scenario; one that begins with ``# name.toml`` is there under that name for the commands below it;
- in a block ``console``, lines ``$ hophoop run …``, ``theory`` and ``plan`` are run and must end with exit status 0; the lines
  below such a command are its output, with ``…`` for what is left out; of other commands every option must exist;
- a block after a comment ``% not run: why`` is left alone, where it needs what no test has;
- a comment ``% says: expression`` stands for itself in no page; the text that the expression gives must be in the paragraph
  (or table) that follows, so that no number in a sentence is typed by hand and forgotten.
"""

import doctest
import re
import shlex
from functools import cache
from pathlib import Path

from typer.testing import CliRunner

import hophoop
import hophoop.cli

FENCE = re.compile(r"^(`{3,})(pycon|python|console|toml)\n(.*?)^\1$", re.MULTILINE | re.DOTALL)
SAYS = re.compile(r"((?:^% says: .+\n)+)((?:.+\n?)+)", re.MULTILINE)
OPTIONS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
CHECKER = doctest.OutputChecker()
FOLDED = re.compile(r"^(:{3,})\{dropdown\}.*?^\1$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"^( *)(`{3,})(\w+|\{eval-rst\})[^\n]*\n(.*?)^\1\2$", re.MULTILINE | re.DOTALL)
COLUMNS = 84  # what a line of code has room for at 1280 pixels


def parts(text):
    """Kind, content, paragraph and line of everything on a page that can be checked, in its order."""
    found = [
        (match.start(), match[2], match[3], "")
        for match in FENCE.finditer(text)
        if not re.search(r"^% not run: .+\n\Z", text[: match.start()], re.MULTILINE)
    ]
    for match in SAYS.finditer(text):
        for line in match[1].splitlines():
            found.append((match.start(), "says", line.removeprefix("% says: "), match[2]))
    for start, kind, content, paragraph in sorted(found, key=lambda part: part[0]):
        yield kind, content, paragraph, text.count("\n", 0, start) + 1


def faults(text, name="page"):
    """What on a page does not hold, one sentence each."""
    space = {}
    result = []
    for kind, content, paragraph, line in parts(text):
        place = f"{name}:{line}"
        if kind == "pycon":
            result += _doctest(content, space, place)
        elif kind == "toml":
            result += _scenario(content, place)
        elif kind == "console":
            result += _commands(content, place)
        elif kind == "python":
            exec(compile(content, place, "exec"), space)
        else:
            value = str(eval(content, space))
            if value not in " ".join(paragraph.split()):
                result.append(f"{place}: {content} is {value}, which the next paragraph does not say")
    return result


def visible(text):
    """A page as those read it who open none of its folded boxes."""
    return FOLDED.sub("", text)


def wide_lines(text):
    """Lines of code that are wider than the page."""
    lines = [line for block in CODE.finditer(text) for line in block[4].splitlines()]
    return [line for line in lines if len(line) > COLUMNS and not line.lstrip().startswith((":alt:", ":caption:"))]


def wrong_installs(text):
    """Commands that ask an index for hophoop, which is on none, or whose quotes fail in cmd.exe."""
    return [line for line in re.findall(r"pip install [^\n`]*", text) if re.search(r"'|[\s\"]hophoop\b", line)]


def _doctest(content, space, place):
    said = []
    examples = doctest.DocTestParser().get_doctest(content, space, place, place, 0)
    examples.globs = space  # names live on in the blocks that follow
    doctest.DocTestRunner(optionflags=OPTIONS).run(examples, out=said.append, clear_globs=False)
    return ["".join(said)] if said else []


def _scenario(content, place):
    name = re.match(r"# ([\w-]+\.toml)", content)
    path = Path(name[1] if name else "scenario-of-a-page.toml")
    path.write_text(content, encoding="utf-8")
    try:
        hophoop.Scenario.load(path)
    except ValueError as error:
        return [f"{place}: {error}"]
    return []


def _commands(content, place):
    result = []
    for command, said in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", content.replace("\\\n", " "), re.MULTILINE):
        found = re.match(r"hophoop (\w+)\b(.*)", command)
        if found is None:
            continue
        name, rest = found.groups()
        words = shlex.split(rest, comments=True)
        if name in ("run", "theory", "plan"):
            answer = CliRunner().invoke(hophoop.cli.app, [name, *words])
            if answer.exit_code != 0:
                result.append(f"{place}: hophoop {name}{rest} ends with exit status {answer.exit_code}")
            elif said and not CHECKER.check_output(said.replace("…", "..."), answer.output, OPTIONS):
                result.append(f"{place}: hophoop {name}{rest} prints\n{answer.output}")
        unknown = {word.partition("=")[0] for word in words if word.startswith("--")} - options(name)
        result += [f"{place}: hophoop {name} has no option {word}" for word in sorted(unknown)]
    return result


@cache
def options(name):
    """Every option of a command."""
    known = name in hophoop.cli.COMMANDS + hophoop.cli.RESEARCH
    parameters = hophoop.cli.command_of(name).params if known else ()
    return {"--help", *(flag for parameter in parameters for flag in (*parameter.opts, *parameter.secondary_opts))}


PAGE_WIDTH = 736  # pixels of text


def text_sizes(svg):
    """Heights of the text of a drawing [pixel], as a page shows it."""
    shown = float(re.search(r'<svg[^>]*? width="([\d.]+)pt"', svg)[1]) * 96 / 72
    scale = min(1.0, PAGE_WIDTH / shown) * 96 / 72
    return [100 * float(size) * scale for size in re.findall(r"scale\((0?\.\d+) -", svg)]
