"""From a command to its answer: what the first motion and compiling cost. `python benchmarks/start.py [--json]`.

Each command runs in a process of its own, with a cold cache (an empty folder) or a warm one, in turn with Python that imports
NumPy alone; beside the time on the clock stand the seconds of processor time, since the clock also counts what else the
machine does, and the ratio to importing NumPy. `--all` measures on a cold cache, once each, also `hophoop reproduce`, and how
long `hophoop lab` takes until its first motion plays in a headless Chromium, and until its map is whole.
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

COMPILE = """
from hophoop._jit import dispatchers, forced, policy
from hophoop._jit.kernels import describe
import hophoop as hh
from hophoop.maps import kernel
from hophoop.rigid import sampling
from hophoop.simulation import run
import gc, json, time
gc.disable()  # as in the process beside, which compiles
kinds = {{}}
def noting(part):
    def call(*arguments):
        kinds.setdefault(part, tuple(describe(value) for value in arguments))
        return part.interpreted(*arguments)
    part._target = call
for part in (run, sampling.sample, kernel.evaluate_block):
    noting(part)
hh.simulate(hh.Scenario(duration=1.0)).at(0.5)
hh.maps.points(None, {{"start.speed": [1.0]}})
seconds = {{}}
for part, kind in kinds.items():
    began = time.process_time()
    dispatchers.compile_for(part, kind)
    seconds[part.__name__] = time.process_time() - began
print(json.dumps(seconds))
"""
PYTHON = {
    "import numpy": "import numpy",
    "first simulate()": "import hophoop as hh; hh.simulate(hh.Scenario(duration=2.0))",
    "run": "import sys; sys.argv = ['hophoop', 'run', '--v0', '3.1']; from hophoop.cli import app; app()",
    "--help": "import sys; sys.argv = ['hophoop', '--help']; from hophoop.cli import app; app()",
}
REPRODUCE = "import sys; sys.argv = ['hophoop', 'reproduce', '--out', {!r}]; from hophoop.cli import app; app()"


def measured(code, folder, mode="auto"):
    """Seconds on the clock and of the processor for a fresh Python, and what it printed."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": folder, "HOPHOOP_KERNELS": mode}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    wall = time.perf_counter()
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    wall = time.perf_counter() - wall
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, done.stdout


def lab(folder):
    """Seconds from the command to a motion that plays and to a whole map, and what the map said meanwhile."""
    from playwright.sync_api import sync_playwright

    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))))
    environment = {**os.environ, "NUMBA_CACHE_DIR": folder, "HOPHOOP_KERNELS": "auto"}
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
            said = []
            while page.evaluate("hophoopLab.map.level") != 3:
                text = page.locator(".map-head .hint").inner_text()
                if text and text not in said:
                    said.append(text)
                page.wait_for_timeout(100)
            result["whole_map_s"] = time.perf_counter() - began
            result["said"] = [said[0], said[len(said) // 2], said[-1]]
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
    rows = {f"{name}, {state}": [] for name in PYTHON for state in ("cold", "warm")}
    with tempfile.TemporaryDirectory() as warm:
        compiling = json.loads(measured(COMPILE.format(), warm)[2])
        for _ in range(options.rounds):
            for name, code in PYTHON.items():
                with tempfile.TemporaryDirectory() as cold:
                    rows[f"{name}, cold"].append(measured(code, cold)[:2])
                rows[f"{name}, warm"].append(measured(code, warm)[:2])
        compiled = [measured(PYTHON["run"], warm, "compiled")[:2] for _ in range(options.rounds)]
    rows["run, warm, compiled code asked for"] = compiled
    base = statistics.median(processor for _, processor in rows["import numpy, warm"])
    results = {
        name: {
            "wall_s": statistics.median(wall for wall, _ in times),
            "processor_s": statistics.median(processor for _, processor in times),
            "beside_import_numpy": statistics.median(processor for _, processor in times) / base,
        }
        for name, times in rows.items()
    }
    results["compiling, processor"] = compiling
    results["load of the machine before"] = {"average": load}
    if options.all:
        with tempfile.TemporaryDirectory() as cold, tempfile.TemporaryDirectory() as out:
            wall, processor, _ = measured(REPRODUCE.format(out), cold)
            results["reproduce, cold"] = {"wall_s": wall, "processor_s": processor}
        with tempfile.TemporaryDirectory() as cold:
            results["lab, cold"] = lab(cold)
    if options.json:
        print(json.dumps(results, indent=2))
        return
    for name, numbers in results.items():
        shown = (f"{key} {value:.2f}" if isinstance(value, float) else f"{key} {value}" for key, value in numbers.items())
        print(f"{name:36}", "  ".join(shown))


if __name__ == "__main__":
    main()
