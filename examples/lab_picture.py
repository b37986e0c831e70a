"""Pictures of the lab for the documentation, light and dark, taken from the lab itself.

The simple view stands on the front page, everything on the lab's page. The documentation's build takes them anew.

Usage: python examples/lab_picture.py [FOLDER]   (default: docs/_static; needs playwright and Chromium)
"""

from __future__ import annotations

import argparse
import io
import shutil
import threading
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

from hophoop.lab.server import server_of

SIZE = {"width": 1280, "height": 800}
MOMENT = 1.3  # in the air [s]
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
VIEWS = {"lab": "", "lab-everything": "localStorage['hophoop-view'] = 'everything';"}  # what a visitor has chosen before


def take(folder: Path) -> list[Path]:
    """Take all pictures; none where there is no Chromium."""
    chromium = next((found for name in CHROMIUM if (found := shutil.which(name))), None)
    if chromium is None:
        return []
    server = server_of()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_address[1]}/"
    taken = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--enable-unsafe-swiftshader"])
        for scheme in ("light", "dark"):
            for name, chosen in VIEWS.items():
                page = browser.new_context(viewport=SIZE, color_scheme=scheme).new_page()
                page.add_init_script(chosen)
                page.goto(f"{address}#t={MOMENT}")
                page.wait_for_selector("[data-ready]")
                page.wait_for_function("() => hophoopLab.theory.list.children.length > 4")
                page.evaluate(f"() => {{ hophoopLab.clock.play(false); hophoopLab.clock.seek({MOMENT}); }}")
                page.wait_for_timeout(600)
                picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
                taken.append(folder / f"{name}-{scheme}.png")
                picture.quantize(192, dither=Image.Dither.NONE).save(taken[-1], optimize=True)
        browser.close()
    server.shutdown()
    return taken


def main() -> None:
    """Take them into a folder."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, default=Path("docs/_static"))
    if not take(parser.parse_args().folder):
        raise SystemExit(f"There is no Chromium ({', '.join(CHROMIUM)}).")


if __name__ == "__main__":
    main()
