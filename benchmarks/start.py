"""From a command to its answer in a fresh process: `python benchmarks/start.py [--json] [--all]`.

Each command runs in a process of its own, in turn with Python that imports NumPy alone. The table has wall time, processor time
(the clock also counts what else the machine does), and its ratio to that of importing NumPy. Within a process that has imported
hophoop, it has the times of the first and the second motion, and of the first map of 40,000 cells. `--all` also measures
`hophoop reproduce`, and how long `hophoop lab` takes until its first motion plays in a headless Chromium, and until its map is
whole.
"""

import argparse
import json
import os
import resource
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from urllib.request import urlopen

PYTHON = {
    "import numpy": "import numpy",
    "import hophoop, simulate()": "import hophoop as hh; hh.simulate(hh.Scenario(duration=2.0))",
    "hophoop run": "import sys; sys.argv = ['hophoop', 'run', '--v0', '3.1']; from hophoop.cli import app; app()",
    "hophoop --help": "import sys; sys.argv = ['hophoop', '--help']; from hophoop.cli import app; app()",
}
WITHIN = """
import json, time
import numpy as np
import hophoop as hh
from hophoop import maps
scenario, times = hh.Scenario(duration=2.0), [time.perf_counter()]
for _ in range(2):
    hh.simulate(scenario)
    times.append(time.perf_counter())
maps.sweep(None, {"plane.mu": np.linspace(0.01, 2.0, 200), "start.speed": np.linspace(0.01, 5.0, 200)})
times.append(time.perf_counter())
print(json.dumps(dict(zip(("first motion", "second motion", "first map of 40,000 cells"), np.diff(times).tolist()))))
"""
REPRODUCE = "import sys; sys.argv = ['hophoop', 'reproduce', '--out', {!r}]; from hophoop.cli import app; app()"


def measured(code, mode="compiled"):
    """Seconds on the clock and of the processor for a fresh Python, and what it printed."""
    environment = {**os.environ, "HOPHOOP_KERNELS": mode}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    wall = time.perf_counter()
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    wall = time.perf_counter() - wall
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, done.stdout


def lab():
    """Seconds from the command to a motion that plays and to a whole map."""
    from playwright.sync_api import sync_playwright

    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))))
    environment = {**os.environ, "HOPHOOP_KERNELS": "compiled"}
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = (
        "import sys; sys.argv = ['hophoop', 'lab', '--no-browser', '--port', sys.argv[1]]; from hophoop.cli import app; app()"
    )
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--enable-unsafe-swiftshader"])
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.set_default_timeout(300_000)
        began = time.perf_counter()
        server = subprocess.Popen([sys.executable, "-c", command, str(port)], env=environment, stderr=subprocess.DEVNULL)
        try:
            address = f"http://127.0.0.1:{port}/"
            while True:
                try:
                    with urlopen(address + "healthz", timeout=1):
                        break
                except OSError:
                    time.sleep(0.05)
            result = {"answers_s": time.perf_counter() - began}
            page.goto(address)
            page.wait_for_selector("[data-ready]")
            page.evaluate("hophoopLab.clock.play(true)")
            page.wait_for_function("() => hophoopLab.clock.time > 0")
            result["plays_s"] = time.perf_counter() - began
            page.locator(".map-body").scroll_into_view_if_needed()
            page.wait_for_function("() => hophoopLab.map.level === 3")
            result["whole_map_s"] = time.perf_counter() - began
        finally:
            server.terminate()
            server.wait(10)
            browser.close()
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print the numbers as JSON")
    parser.add_argument("--rounds", type=int, default=5, help="how often each command runs")
    parser.add_argument("--all", action="store_true", help="also reproduce and lab, which take a minute")
    options = parser.parse_args()
    load = os.getloadavg()[0]
    asked = {name: (code, "compiled") for name, code in PYTHON.items()}
    asked["hophoop run, interpreted"] = PYTHON["hophoop run"], "interpreted"
    rows, within = {name: [] for name in asked}, []
    for _ in range(options.rounds):
        for name, given in asked.items():
            rows[name].append(measured(*given)[:2])
        within.append(json.loads(measured(WITHIN)[2]))
    base = statistics.median(processor for _, processor in rows["import numpy"])
    results = {
        name: {
            "wall_s": statistics.median(wall for wall, _ in times),
            "processor_s": statistics.median(processor for _, processor in times),
            "ratio_to_import_numpy": statistics.median(processor for _, processor in times) / base,
        }
        for name, times in rows.items()
    }
    results |= {name: {"wall_ms": 1e3 * statistics.median(each[name] for each in within)} for name in within[0]}
    results["load of the machine before"] = {"average": load}
    if options.all:
        with tempfile.TemporaryDirectory() as out:
            wall, processor, _ = measured(REPRODUCE.format(out))
            results["hophoop reproduce"] = {"wall_s": wall, "processor_s": processor}
        results["hophoop lab"] = lab()
    if options.json:
        print(json.dumps(results, indent=2))
        return
    for name, numbers in results.items():
        shown = (f"{key} {value:.2f}" if isinstance(value, float) else f"{key} {value}" for key, value in numbers.items())
        print(f"{name:36}", "  ".join(shown))


if __name__ == "__main__":
    main()
