"""How fast the lab is without a server: the exported folder in headless Chromium, and the module beside the library.

    python benchmarks/page.py

Prints one JSON object. Needs playwright and a Chromium, and Node for the times of the module alone.
"""

from __future__ import annotations

import functools
import gzip
import http.server
import json
import os
import shutil
import subprocess
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.lab import export as site
from hophoop.lab.wasm.stamp import HERE, MODULE

ROUNDS = 20

MOVES = """async () => {
  const slider = document.querySelector("input[data-path='start.speed']");
  hophoopLab.latencies.length = 0;
  for (let k = 0; k < 120; k++) {
    slider.value = String(2 + 0.01 * k);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    await new Promise((resolve) => setTimeout(resolve, 80));
  }
  return hophoopLab.latencies;
}"""

FRAMES = """async () => {
  hophoopLab.clock.play(true);
  await new Promise((resolve) => setTimeout(resolve, 500));
  const before = hophoopLab.frames;
  await new Promise((resolve) => setTimeout(resolve, 4000));
  const frames = hophoopLab.frames - before;
  hophoopLab.clock.play(false);
  return frames / 4;
}"""

CELLS = """async () => {
  const { scenario } = hophoopLab.film();
  const axis = (path, from, to, cells) => ({ path, from, to, cells });
  const body = { scenario, what: "sequence", x: axis("start.speed", 0.1, 4, 160), y: axis("plane.mu", 0.1, 1.4, 100) };
  const times = [];
  for (let k = 0; k < 5; k++) {
    const begun = performance.now();
    await hophoopLab.backend.map(body);
    times.push(performance.now() - begun);
  }
  return { cells: 16000, workers: hophoopLab.backend.kernel.maps.started, times };
}"""


def serve(folder: Path) -> tuple[http.server.ThreadingHTTPServer, str]:
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_: Any) -> None:
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server, f"http://127.0.0.1:{server.server_address[1]}/"


def in_chromium(address: str) -> dict[str, Any]:
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--enable-unsafe-swiftshader"])
        first = []
        for _ in range(5):
            context = browser.new_context(viewport={"width": 1440, "height": 900})
            page = context.new_page()
            page.goto(address)
            page.wait_for_selector("[data-ready]")
            first.append(page.evaluate("performance.now()"))
            context.close()
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.goto(address)
        page.wait_for_selector("[data-ready]")
        page.wait_for_timeout(3000)
        latencies = page.evaluate(MOVES)
        rate = page.evaluate(FRAMES)
        found = page.evaluate(CELLS)
        browser.close()
    return {
        "first_motion_after_load_ms": round(float(np.median(first)), 1),
        "slider_to_picture_median_ms": round(float(np.median(latencies)), 1),
        "slider_to_picture_p90_ms": round(float(np.quantile(latencies, 0.9)), 1),
        "frames_per_second": round(rate, 1),
        "map_cells_per_second": round(found["cells"] / min(found["times"]) * 1e3),
        "map_workers": found["workers"],
    }


def in_node() -> dict[str, float] | None:
    """Time of the reference motion in the module, beside the library's in the same seconds [µs]."""
    node = shutil.which("node")
    if node is None:
        return None
    script = f"""
      import {{ readFileSync }} from "node:fs";
      const {{ HoopModule }} = await import({json.dumps(str(HERE.parent / "static" / "kernel.js"))});
      const module = new HoopModule(await WebAssembly.compile(readFileSync({json.dumps(str(HERE / MODULE))})));
      const given = {{ radius: 1, mass: 1, eccentricity: 0.75, inertia_ratio: 0.4375, ideal: true, gravity: 9.81, slope: 0,
        rolling_resistance: 0, mu_static: 1, mu_kinetic: 1, restitution: 0, impact_law: "stronge", painleve: "flight", x: 0,
        height: 0, angle: 0, vx: 3.1, vy: 0, omega: 3.1, slip: 0, rolling: true, duration: 6, max_events: 10000,
        contact: null }};
      for (let k = 0; k < 500; k++) module.compute(given);
      let best = Infinity;
      for (let round = 0; round < {ROUNDS}; round++) {{
        const begun = performance.now();
        for (let k = 0; k < 500; k++) module.compute(given);
        best = Math.min(best, (performance.now() - begun) / 500);
      }}
      console.log(best * 1e3);
    """
    done = subprocess.run([node, "--input-type=module", "-e", script], capture_output=True, text=True, check=True)
    scenario = hh.Scenario()
    best = float("inf")
    for _ in range(ROUNDS):
        begun = time.perf_counter()
        for _ in range(500):
            hh.simulate(scenario)
        best = min(best, (time.perf_counter() - begun) / 500)
    module, library = float(done.stdout), 1e6 * best
    return {"module_us": round(module, 1), "simulate_us": round(library, 1), "ratio": round(module / library, 2)}


def main() -> None:
    files = site.site_files()
    page = ("index.html", "static/lab.js", "static/kernel.js", "static/lab.css", f"static/{MODULE}", "static/icon.svg")
    with tempfile.TemporaryDirectory() as folder:
        site.export(Path(folder) / "lab")
        server, address = serve(Path(folder) / "lab")
        try:
            result = {
                "cores": os.cpu_count(),
                "load_average": round(os.getloadavg()[0], 2),
                "kilobytes_gzip": {name: round(len(gzip.compress(files[name], 9)) / 1e3, 1) for name in page},
                "node": in_node(),
                "chromium": in_chromium(address),
            }
        finally:
            server.shutdown()
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
