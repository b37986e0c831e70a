"""The built pages, as CI's part `docs` makes them; elsewhere these tests are left out."""

import functools
import http.server
import os
import threading
from pathlib import Path

import pytest


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *words):
        pass


@pytest.fixture(scope="session")
def site():
    """The folder of the pages."""
    folder = os.environ.get("HOPHOOP_BUILT_SITE")
    if folder is None:
        pytest.skip("HOPHOOP_BUILT_SITE names no built documentation (.ci/run docs does)")
    return Path(folder)


@pytest.fixture(scope="session")
def address(site):
    """The pages on loopback."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
