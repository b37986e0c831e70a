"""Picture of the lab for the front page of the documentation, light and dark, taken from the lab itself.

Usage: python examples/lab_picture.py [FOLDER]   (default: docs/_static; needs playwright and Chromium)
"""

from __future__ import annotations

import argparse
import io
import shutil
import threading
import time
from pathlib import Path

import uvicorn
from PIL import Image
from playwright.sync_api import sync_playwright

from hophoop.lab.server import routes

SIZE = {"width": 1280, "height": 800}
MOMENT = 1.3  # in the air [s]
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")


def serve() -> tuple[uvicorn.Server, str]:
    """The lab on loopback, and its address."""
    server = uvicorn.Server(uvicorn.Config(routes.create_app(), host="127.0.0.1", port=0, log_level="error"))
    threading.Thread(target=server.run, daemon=True).start()
    while not server.started:
        time.sleep(0.02)
    return server, f"http://127.0.0.1:{server.servers[0].sockets[0].getsockname()[1]}/"


def main() -> None:
    """Take both pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, default=Path("docs/_static"))
    folder = parser.parse_args().folder
    chromium = next(found for name in CHROMIUM if (found := shutil.which(name)))
    server, address = serve()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--enable-unsafe-swiftshader"])
        for scheme in ("light", "dark"):
            page = browser.new_page(viewport=SIZE, color_scheme=scheme)
            page.goto(f"{address}#t={MOMENT}")
            page.wait_for_selector("[data-ready]")
            page.wait_for_function("() => hophoopLab.theory.list.children.length > 4")
            page.evaluate(f"() => {{ hophoopLab.clock.play(false); hophoopLab.clock.seek({MOMENT}); }}")
            page.wait_for_timeout(600)
            picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            picture.quantize(192, dither=Image.Dither.NONE).save(folder / f"lab-{scheme}.png", optimize=True)
        browser.close()
    server.should_exit = True


if __name__ == "__main__":
    main()
