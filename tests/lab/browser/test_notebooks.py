"""The player in a running Jupyter and a running marimo; left out where they are not installed."""

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import time
from importlib.util import find_spec
from urllib.request import urlopen

import pytest

SHOW = """\
import hophoop as hh
motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1))
player = hh.show(motion)
"""
TOLD = "f'at {player.motion.scenario.start.speed} {player.motion.sequence}'"
MARIMO = f"""\
import marimo
app = marimo.App()

@app.cell
def _():
    import marimo as mo
{"".join(f"    {line}" for line in SHOW.splitlines(keepends=True))}
    view = mo.ui.anywidget(player)
    view
    return mo, player, view

@app.cell
def _(mo, player, view):
    view.value["query"]
    mo.md({TOLD})
    return
"""


@contextlib.contextmanager
def opened(browser, folder, command, place=""):
    """A page of a server of notebooks in a folder, as soon as it answers; `command` has a place for the port."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    words = [sys.executable, "-m", *command.format(port=port).split()]
    with open(folder / "server.log", "wb") as log:
        server = subprocess.Popen(words, cwd=folder, stdout=log, stderr=log, start_new_session=True)
    page, troubles = browser.new_page(viewport={"width": 1440, "height": 1000}), []
    try:
        for _ in range(300):
            assert server.poll() is None, (folder / "server.log").read_text()
            with contextlib.suppress(OSError), urlopen(f"http://127.0.0.1:{port}/", timeout=5):
                break
            time.sleep(0.2)
        page.set_default_timeout(90_000)
        page.on("pageerror", lambda error: troubles.append(str(error)))
        page.on("console", lambda said: said.type == "error" and "hophoop" in said.text and troubles.append(said.text))
        page.goto(f"http://127.0.0.1:{port}/{place}")
        yield page
    finally:
        page.close()
        with contextlib.suppress(ProcessLookupError):
            os.killpg(server.pid, signal.SIGTERM)
        server.wait(20)
    assert troubles == []


def slide_to(page, speed):
    slider = page.locator("input[data-path='start.speed']")
    slider.scroll_into_view_if_needed()
    slider.fill(speed)
    page.wait_for_function("() => document.querySelector('.summary').textContent === 'Rolls.'")


@pytest.mark.skipif(find_spec("jupyterlab") is None, reason="JupyterLab is not installed")
def test_jupyter_plays_and_its_slider_changes_the_motion(browser, tmp_path):
    cells = [
        {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": source}
        for source in (SHOW + "player", f"print({TOLD})")
    ]
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    book = {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 4}
    (tmp_path / "hoop.ipynb").write_text(json.dumps(book))
    command = (
        "jupyterlab --no-browser --ip=127.0.0.1 --port={port} --ServerApp.port_retries=0 --allow-root"
        f" --IdentityProvider.token= --ServerApp.password= --ServerApp.root_dir={tmp_path}"
    )
    with opened(browser, tmp_path, command, "lab/tree/hoop.ipynb?reset") as page:
        cell = page.locator(".jp-Notebook .jp-CodeCell")
        cell.first.click()
        page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]").wait_for()
        page.keyboard.press("Shift+Enter")
        page.locator(".hophoop[data-ready]").wait_for()
        assert "hops at 315.6°" in page.locator(".summary").inner_text()
        # Jupyter's own styles leave the readout as it is
        assert page.locator(".readout").bounding_box()["width"] < 160
        # keys that Jupyter would take to delete cells, to make them text and to restart the kernel
        page.locator(".stage").click()
        for key in "ddm300":
            page.keyboard.press(key)
        assert page.locator(".stage canvas").last.is_visible()  # in space
        assert cell.count() == 2
        assert page.locator(".jp-Dialog").count() == 0
        slide_to(page, "2")
        cell.nth(1).click()
        page.keyboard.press("Shift+Enter")
        cell.nth(1).locator(".jp-OutputArea-output", has_text="at 2.0 R").wait_for()


@pytest.mark.skipif(find_spec("marimo") is None, reason="marimo is not installed")
def test_marimo_plays_and_other_cells_follow(browser, tmp_path):
    (tmp_path / "hoop.py").write_text(MARIMO)
    with opened(browser, tmp_path, "marimo run hoop.py --headless --host 127.0.0.1 --port {port} --no-token") as page:
        page.locator(".hophoop[data-ready]").wait_for()
        assert "hops at 315.6°" in page.locator(".summary").inner_text()
        page.get_by_text("at 3.1 RKRSH").wait_for()
        slide_to(page, "2")
        page.get_by_text("at 2.0 R", exact=True).wait_for()
