"""The system's Chromium, driven by playwright; without either, these tests are left out."""

import json
import os

import pytest

from browser_tools import served
from lab_page_tools import PATIENCE, serving
from slow_page import delaying

DELAYS = os.environ.get("HOPHOOP_PAGE_DELAYS", "")  # a seed: every page of these tests is delayed at random
OWN = ("http://127.0.0.1:", "data:", "blob:", "about:")
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
    (made / "favicon.ico").touch()  # browsers ask for it beside a text, at any later time
    return made


@pytest.fixture(scope="session")
def site_address(site_folder):
    with served(site_folder) as address:
        yield address


@pytest.fixture(scope="session")
def windows():
    """Pages that stay open from test to test, as a new context costs more than most tests, by the kind of window."""
    return {}


@pytest.fixture(scope="session")
def troubles():
    """What has gone wrong in the pages of a test."""
    return []


@pytest.fixture
def visit(browser, new_page, windows, troubles, address, request):
    """Opens a page, with empty storage; at the end nothing may have gone wrong in any of them.

    A test that adds routes or scripts to its page asks for one of its `own`.
    """
    visited, allowed = set(), []
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
            page.on("pageerror", lambda error: troubles.append(f"page: {error}"))
            page.on("console", lambda said: said.type == "error" and troubles.append(f"console: {said.text}"))
            page.on("request", lambda asked: asked.url.startswith(OWN) or troubles.append(f"left loopback: {asked.url}"))
        page.set_viewport_size(options["viewport"])
        visited.add(page)
        allowed.extend(expected)
        page.goto(address + query)
        if ready:
            page.wait_for_selector("[data-ready]")
        return page

    yield open_page
    for page in visited:
        page.evaluate("0")  # what was said before is heard
    found = [trouble for trouble in troubles if not any(part in trouble for part in allowed)]
    for page in visited & {*windows.values()}:
        page.goto(f"{address}static/licences.txt")  # a text, which writes no more
        page.evaluate("localStorage.clear(); sessionStorage.clear()")
    troubles.clear()
    assert found == []
