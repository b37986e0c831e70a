"""The system's Chromium, driven by playwright; without either, these tests are left out."""

import functools
import http.server
import os
import threading
from importlib.util import find_spec
from urllib.parse import urlsplit

import pytest

from lab_page_tools import PATIENCE, serving
from slow_page import delaying

# The server of the page needs the extra "lab".
collect_ignore_glob = [] if find_spec("uvicorn") else ["test_*.py"]

DELAYS = os.environ.get("HOPHOOP_PAGE_DELAYS", "")  # a seed: every page of these tests is delayed at random
SLOWER = 8
# As for those who have asked for everything before: the simple view, and what opens it, have tests of their own.
EVERYTHING = "try { localStorage['hophoop-view'] ??= 'everything'; } catch { /* no storage */ }"


@pytest.fixture(scope="session")
def address():
    """The lab on loopback."""
    with serving() as served:
        yield served


@pytest.fixture(scope="session")
def site_folder(tmp_path_factory):
    """The lab as a folder of files."""
    from hophoop.lab.site import export as site

    made = tmp_path_factory.mktemp("site")
    site.export(made)
    return made


@pytest.fixture(scope="session")
def site_address(site_folder):
    """The folder, served by Python's plain web server."""

    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=site_folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_address[1]}/"
    server.shutdown()
    server.server_close()


@pytest.fixture
def visit(browser, address, request):
    """Opens a page; at the end nothing may have gone wrong in any of them."""
    contexts, troubles = [], []
    seed = getattr(request, "param", None) or DELAYS

    def trouble(kind, text):
        troubles.append(f"{kind}: {text}")

    def open_page(query="", ready=True, expected=(), script="", simple=False, **options):
        options.setdefault("viewport", {"width": 1440, "height": 900})
        context = browser.new_context(**options)
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(PATIENCE)
        if seed:  # a slower processor, for this page alone
            context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": SLOWER})
        if seed:
            page.add_init_script(delaying(int(seed)))
        if not simple:
            page.add_init_script(EVERYTHING)
        if script:
            page.add_init_script(script)
        page.on("pageerror", lambda error: trouble("page", error))
        page.on(
            "console",
            lambda said: (
                said.type == "error" and not any(part in said.text for part in expected) and trouble("console", said.text)
            ),
        )
        page.on("request", lambda request: check(request.url))
        page.goto(address + query)
        if ready:
            page.wait_for_selector("[data-ready]")
        return page

    def check(url):
        parts = urlsplit(url)
        if parts.scheme in ("http", "https", "ws", "wss") and parts.hostname != "127.0.0.1":
            trouble("left loopback", url)

    yield open_page
    for context in contexts:
        context.close()
    assert troubles == []
