"""The system's Chromium, driven by playwright; without either, the tests that want it are left out."""

import contextlib
import functools
import http.server
import shutil
import threading

import pytest

# Off, what playwright turns off (of two such lists Chromium takes the last), and what a window has that nobody types an address
# into: the list under its address bar is two pages of Chromium's own, which cost as much as the page of a test.
OFF = (
    "AvoidUnnecessaryBeforeUnloadCheckSync",
    "DestroyProfileOnBrowserClose",
    "HttpsUpgrades",
    "HttpsFirstBalancedModeAutoEnable",
    "LensOverlay",
    "MediaRouter",
    "PaintHolding",
    "ThirdPartyStoragePartitioning",
    "OptimizationHints",
    "NetworkTimeServiceQuerying",
    "AimEnabled",
    "PreconnectToSearch",
    "PreloadTopChromeWebUI",
    "WebUIOmniboxPopup",
    "WebUIOmniboxAimPopup",
)
# WebGL without a graphics card
FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--mute-audio", f"--disable-features={','.join(OFF)}"]
NAMES = ("chromium", "chromium-browser", "google-chrome")


@pytest.fixture(scope="session")
def browser():
    sync_api = pytest.importorskip("playwright.sync_api")
    chromium = next((found for name in NAMES if (found := shutil.which(name))), None)
    if chromium is None:
        pytest.skip("no Chromium is installed (Debian: apt-get install chromium)")
    with sync_api.sync_playwright() as playwright:
        launched = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        yield launched
        launched.close()


@pytest.fixture
def new_page(browser):
    """Opens pages with storage of their own; all are closed at the end."""
    with contextlib.ExitStack() as opened:
        yield lambda **options: opened.enter_context(contextlib.closing(browser.new_page(**options)))


@contextlib.contextmanager
def served(folder, seconds=0):
    """The address of a folder, by Python's plain web server; browsers may keep its files for so many seconds."""

    class Quiet(http.server.SimpleHTTPRequestHandler):
        def end_headers(self):
            if seconds:
                self.send_header("Cache-Control", f"max-age={seconds}")
            super().end_headers()

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()
