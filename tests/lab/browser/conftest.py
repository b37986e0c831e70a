"""The system's Chromium, driven by playwright; without either, these tests are left out."""

import json
import os
from urllib.parse import urlsplit

import pytest

from browser_tools import served
from lab_page_tools import PATIENCE, serving
from slow_page import delaying

DELAYS = os.environ.get("HOPHOOP_PAGE_DELAYS", "")  # a seed: every page of these tests is delayed at random
SLOWER = 2  # more costs the processor as much, and the delays already change the order
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
    from hophoop.lab import export as site

    made = tmp_path_factory.mktemp("site")
    site.export(made)
    return made


@pytest.fixture(scope="session")
def site_address(site_folder):
    with served(site_folder) as address:
        yield address


@pytest.fixture(scope="session")
def windows():
    """Pages that stay open from test to test, as a new context costs more than most tests, by the kind of window."""
    return {}


@pytest.fixture
def visit(browser, new_page, windows, address, request):
    """Opens a page, with empty storage; at the end nothing may have gone wrong in any of them.

    A test that adds routes or scripts to its page asks for one of its `own`.
    """
    heard, troubles = [], []
    seed = getattr(request, "param", None) or DELAYS

    def open_page(query="", ready=True, expected=(), script="", simple=False, own=False, **options):
        options.setdefault("viewport", {"width": 1440, "height": 900})
        kind = None if own or script or seed else json.dumps([simple, options], sort_keys=True)
        page = windows.get(kind)
        if page is None:
            page = (browser.new_page if kind else new_page)(**options)
            page.set_default_timeout(PATIENCE)
            if seed:  # a slower processor, for this page alone
                page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": SLOWER})
                page.add_init_script(delaying(int(seed)))
            if not simple:
                page.add_init_script(EVERYTHING)
            if script:
                page.add_init_script(script)
            if kind:
                windows[kind] = page
        page.set_viewport_size(options["viewport"])

        def console(said):
            if said.type == "error" and not any(part in said.text for part in expected):
                troubles.append(f"console: {said.text}")

        def asked(request):
            parts = urlsplit(request.url)
            if parts.scheme in ("http", "https", "ws", "wss") and parts.hostname != "127.0.0.1":
                troubles.append(f"left loopback: {request.url}")

        hears = {"pageerror": lambda error: troubles.append(f"page: {error}"), "console": console, "request": asked}
        for name, hear in hears.items():
            page.on(name, hear)
        heard.append((page, hears))
        page.goto(address + query)
        if ready:
            page.wait_for_selector("[data-ready]")
        return page

    yield open_page
    for page, hears in heard:
        page.evaluate("0")  # what was said before is heard
        for name, hear in hears.items():
            page.remove_listener(name, hear)
    for page in {page for page, _ in heard} & set(windows.values()):
        page.goto(f"{address}static/x")  # nothing, which writes no more
        page.evaluate("localStorage.clear(); sessionStorage.clear()")
    assert troubles == []
