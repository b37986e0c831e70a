"""Sources of web/ for Node, which reads no TypeScript in all of its versions: bundled first by esbuild."""

import functools
import json
import re
import shutil
import subprocess

import pytest

from checkout import ROOT, text_of

WEB = ROOT / "web"
BUNDLE = """
import { build } from "esbuild";
const options = { bundle: true, format: "esm", platform: "node", write: false };
const { outputFiles } = await build({ entryPoints: [process.argv[1]], ...options });
process.stdout.write(outputFiles[0].text);
"""

needs_node = pytest.mark.skipif(
    shutil.which("node") is None or not (WEB / "node_modules").is_dir(),
    reason="no Node with the tools of web/ (npm install --prefix web)",
)


@functools.cache
def bundled(path):
    """A module and all that it imports, as one text that Node runs."""
    command = ["node", "--input-type=module", "--eval", BUNDLE, path]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", cwd=WEB, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@functools.cache
def _english():
    return json.loads(text_of("src/hophoop/lab/words/en.json"))


def english(said):
    """What the page says, as web/words/texts.ts puts it together."""
    if isinstance(said, list):
        return "".join(english(part) for part in said)
    if not isinstance(said, dict):
        text = _english().get(said, said) if isinstance(said, str) else str(said)
        return str(text)
    text, values = _english()[said["key"]], said.get("values", {})
    if isinstance(text, dict):
        text = text["one" if values["count"] == 1 else "other"]
    return re.sub(r"\{(\w+)\}", lambda place: english(values[place[1]]), text)
