"""From a command to its answer: what the first motion and compiling cost. `python benchmarks/start.py [--json]`.

Each command runs in a process of its own, with a cold cache (an empty folder) or a warm one, in turn with Python that imports
NumPy alone; beside the time on the clock stand the seconds of processor time, since the clock also counts what else the
machine does, and the ratio to importing NumPy.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

COMPILE = """
from hophoop._jit import dispatchers, forced, policy
from hophoop._jit.kernels import describe
import hophoop as hh
from hophoop.maps import kernel
from hophoop.rigid import sampling
from hophoop.simulation import run
import json, time
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


def measured(code, folder, mode="auto"):
    """Seconds on the clock and of the processor for a fresh Python, and what it printed."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": folder, "HOPHOOP_KERNELS": mode}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    wall = time.perf_counter()
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    wall = time.perf_counter() - wall
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print the numbers as JSON")
    parser.add_argument("--rounds", type=int, default=5, help="how often each command runs")
    options = parser.parse_args()
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
    if options.json:
        print(json.dumps(results, indent=2))
        return
    for name, numbers in results.items():
        print(f"{name:36}", "  ".join(f"{key} {value:.2f}" for key, value in numbers.items()))


if __name__ == "__main__":
    main()
