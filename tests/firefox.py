"""The system's Firefox, driven by WebDriver BiDi (https://w3c.github.io/webdriver-bidi)."""

import contextlib
import itertools
import json
import re
import shutil
import subprocess

import pytest

NAMES = ("firefox-esr", "firefox")
# without a network, and without what a new profile shows or asks for
OFFLINE = 'user_pref("network.manage-offline-status", false);\nuser_pref("browser.offline", true);\n'


@contextlib.contextmanager
def firefox(profile):
    """Context with a tab of Firefox that has no network; `profile`: an empty folder."""
    client = pytest.importorskip("websockets.sync.client")
    program = next((found for name in NAMES if (found := shutil.which(name))), None)
    if program is None:
        pytest.skip("no Firefox is installed (Debian: apt-get install firefox-esr)")
    (profile / "user.js").write_text(OFFLINE)
    command = [program, "--headless", "--profile", str(profile), "--remote-debugging-port", "0"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        try:
            address = next(found[1] for line in process.stderr if (found := re.search(r"BiDi listening on (\S+)", line)))
            with client.connect(f"{address}/session", max_size=None) as line:
                yield Tab(line)
        finally:
            process.kill()


class Tab:
    """A tab of Firefox."""

    def __init__(self, line):
        self.line, self.numbers = line, itertools.count()
        self.call("session.new", capabilities={})
        self.tab = self.call("browsingContext.getTree")["contexts"][0]["context"]

    def call(self, method, **given):
        number = next(self.numbers)
        self.line.send(json.dumps({"id": number, "method": method, "params": given}))
        answer = {}
        while answer.get("id") != number:
            answer = json.loads(self.line.recv())
        assert "result" in answer, answer
        return answer["result"]

    def size(self, width, height):
        self.call("browsingContext.setViewport", context=self.tab, viewport={"width": width, "height": height})

    def open(self, address):
        self.call("browsingContext.navigate", context=self.tab, url="about:blank", wait="complete")
        self.call("browsingContext.navigate", context=self.tab, url=address, wait="complete")

    def ask(self, body):
        """What the body of an asynchronous function returns in the page; numbers, words and lists arrive as JSON."""
        expression = f"(async () => {{ {body} }})().then(JSON.stringify)"
        found = self.call("script.evaluate", expression=expression, target={"context": self.tab}, awaitPromise=True)
        assert found["type"] == "success", found
        return json.loads(found["result"].get("value", "null"))

    def drag(self, *places):
        """Press at the first place, move over the others, and let go."""
        moves = [{"type": "pointerMove", "x": round(x), "y": round(y), "duration": 50} for x, y in places]
        steps = [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:], {"type": "pointerUp", "button": 0}]
        hand = {"type": "pointer", "id": "hand", "parameters": {"pointerType": "mouse"}, "actions": steps}
        self.call("input.performActions", context=self.tab, actions=[hand])
