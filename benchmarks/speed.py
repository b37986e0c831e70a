"""How fast everything but the rigid kernel, maps and the page is: one table.

    python benchmarks/speed.py                  # all, about five minutes
    python benchmarks/speed.py fitting proofs   # some

rigid.py, maps.py and page.py measure those three. A time is the least processor time of some calls, since the clock also counts
what else the machine does; films and the lab, of several processes, go by the clock. Hz is how many a second.
"""

from __future__ import annotations

import argparse
import http.client
import math
import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import numpy as np

import hophoop as hh

HOP = hh.Scenario(duration=2.0)
PATHS = (
    "hoop.load_fraction", "hoop.radius", "hoop.mass", "plane.gravity", "plane.slope", "plane.mu_static",
    "plane.mu_kinetic", "plane.restitution", "start.x", "start.angle", "start.speed", "duration",
)  # fmt: skip
QUANTITIES = [
    "takeoff.t", "takeoff.angle", "hop.height", "hop.distance", "hop.duration", "impact.slip", "end.x", "energy_lost",
]  # fmt: skip
SLOPES = ((1.0, 0.75, 3.4), (3.0, 0.5, 2.7), (4.0, 0.75, 3.4), (3.0, 0.15, 8.0))  # degrees, γ, θ̇

Rows = Iterator[tuple[str, float, str]]


def least(call: Callable[[], Any], repeats: int = 5, clock: Callable[[], float] = time.process_time) -> float:
    """Least time of a call, after one that loads what it needs [s]."""
    call()
    times = []
    for _ in range(repeats):
        began = clock()
        call()
        times.append(clock() - began)
    return min(times)


def children() -> float:
    """Processor time of all processes that this one has started and seen end [s]."""
    used = os.times()
    return used.children_user + used.children_system


def derivatives() -> Rows:
    """What derivatives cost, next to the motion."""
    motion = hh.simulate(HOP)
    yield "simulate(), 2 s", 1e6 * least(lambda: hh.simulate(HOP), 400), "µs"
    for name, wanted in (("1 quantity", "takeoff.angle"), ("8 quantities", QUANTITIES)):
        took = least(lambda wanted=wanted: motion.sensitivity(wanted, PATHS), 400)
        yield f"{name} by 12 parameters", 1e6 * took, "µs"


def compliant() -> Rows:
    """Compliant motions, next to the rigid one."""
    base, weight = least(lambda: hh.simulate(HOP), 100), HOP.hoop.mass * HOP.plane.gravity / HOP.hoop.radius
    for friction in ("tanh", "bristle"):
        for stiffness in (1e6, 1e12):
            contact = hh.Compliant(stiffness=stiffness * weight, friction=friction, rtol=1e-9)
            soft = HOP.model_copy(update={"contact": contact})
            yield f"{friction}, {stiffness:.0e} m g/R", least(lambda soft=soft: hh.simulate(soft)) / base, "times simulate()"


def gaits() -> Rows:
    """Revolutions of the return map, next to SciPy, and fates on the level."""
    from scipy.integrate import solve_ivp

    for degrees, gamma, omega in SLOPES:
        plane = hh.Plane(slope=math.radians(degrees), gravity=1.0)
        scenario = hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=plane, start=hh.Start.rolling(omega, angle=math.pi))
        took = least(lambda scenario=scenario: hh.passages(scenario, 5_000), 3)
        yield f"revolution, slope {degrees:g}°, γ = {gamma:g}", 1e6 * took / 5_000, "µs"

    def rates(_: float, state: Any) -> tuple[float, float]:
        th, om = state
        return om, 0.75 * math.sin(th) * (1.0 + om * om) / (2.0 + 1.5 * math.cos(th))

    def bottom(_: float, state: Any) -> float:
        return math.sin(0.5 * (state[0] - math.pi))

    def roll() -> int:
        found = solve_ivp(rates, (0.0, 100.0), (math.pi, 3.4), "DOP853", events=bottom, rtol=1e-10, atol=1e-12)
        return len(found.t_events[0])

    yield "revolution, SciPy's DOP853, rolling alone", 1e6 * least(roll, 3) / roll(), "µs"
    random = np.random.default_rng(1)
    some = [
        hh.Scenario(plane=hh.Plane(gravity=1.0, mu=mu), start=hh.Start.rolling(speed))
        for mu, speed in zip(random.uniform(0.005, 2.0, 1000), random.uniform(0.005, 4.0, 1000), strict=True)
    ]
    yield "fates on the level", 1000 / least(lambda: hh.gaits.fates(some), 1), "Hz"


def proofs() -> Rows:
    """A proof of the hop."""
    from hophoop.prove import prove

    for digits in (18, 30, 60):
        yield f"{digits} digits", least(lambda digits=digits: prove(HOP, digits), 3), "s"


def fitting() -> Rows:
    """A fit of seven parameters to 240 frames, and a film tracked."""
    from film_maker import Film, article_like, make
    from hophoop.tracking import Hints
    from hophoop.tracking.table import track_of

    plane = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
    start = hh.Start.rolling(1.9, angle=0.1)
    t, random = np.arange(240) / 240, np.random.default_rng(1)
    state = hh.simulate(hh.Hoop.ideal(0.6, radius=0.3), plane, start, duration=1.01).at(t)
    columns = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    columns = {name: values + random.normal(0, 1e-3, 240) for name, values in columns.items()}
    columns |= {f"sigma_{name}": np.full(240, 1e-3) for name in columns}
    yield "fit of 240 frames", least(lambda: hh.fit(track_of(t, columns, radius=0.3, placed=True)), 3), "s"
    film = Film(size=(1280, 720), scale=330.0, origin=(120.0, 600.0), focal=1150.0, frames=240, marker_size=0.04, busy=True)
    with tempfile.TemporaryDirectory() as folder:
        path = make(Path(folder) / "film.mp4", article_like(), film)
        yield "track, 1280 × 720", 1e3 * least(lambda: hh.track(path, 0.3, Hints(exposure=film.shutter)), 2) / 240, "ms a frame"


def films() -> Rows:
    """Pictures of finished films at 1280 × 720."""
    from hophoop.animate import Look, Look3D, Timing, film, film_3d

    motion = hh.simulate(HOP.replace("duration", 4.0))
    with tempfile.TemporaryDirectory() as folder:
        for name, make, look, kind, pictures in (
            ("2D", film, Look(), "mp4", 240),
            ("2D", film, Look(), "webm", 240),
            ("2D with panels", film, Look(panels=("velocity", "energy", "utilization", "phase")), "mp4", 240),
            ("3D", film_3d, Look3D(), "mp4", 60),
        ):
            path, timing = Path(folder) / f"film.{kind}", Timing(fps=pictures / 4.0)
            took = least(
                lambda make=make, path=path, timing=timing, look=look: make([motion], path, timing, look), 1, time.perf_counter
            )
            yield f"{name}, {kind}", pictures / took, "Hz"


def start() -> Rows:
    """From a command to its answer in a fresh process."""
    run = "import sys; sys.argv = ['hophoop', {}]; from hophoop.cli import app; app()"
    clock = "time.process_time()"
    first = f"import hophoop as hh, time; began = {clock}; hh.simulate(hh.Scenario()); print({clock} - began)"
    for name, code, kernels in (
        ("import numpy", "import numpy", "compiled"),
        ("import hophoop, simulate()", "import hophoop as hh; hh.simulate(hh.Scenario(duration=2.0))", "compiled"),
        ("hophoop --help", run.format("'--help'"), "compiled"),
        ("hophoop run", run.format("'run'"), "compiled"),
        ("hophoop run, kernels interpreted", run.format("'run'"), "interpreted"),
    ):
        yield name, least(lambda code=code, kernels=kernels: _python(code, kernels), 3, children), "s"
    yield "first motion of a process", 1e3 * min(float(_python(first, "compiled")) for _ in range(3)), "ms"
    again = first.replace("time; began", "time; hh.simulate(hh.Scenario()); began")
    yield "motion of 6 s, kernels interpreted", 1e3 * min(float(_python(again, "interpreted")) for _ in range(3)), "ms"


def _python(code: str, kernels: str) -> str:
    surroundings = os.environ | {"HOPHOOP_KERNELS": kernels}
    return subprocess.run([sys.executable, "-c", code], env=surroundings, capture_output=True, text=True, check=True).stdout


def lab() -> Rows:
    """The server of the page: until it answers."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = int(probe.getsockname()[1])
    command = [sys.executable, "-m", "hophoop", "lab", "--no-browser", "--port", str(port)]
    server = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        began = time.perf_counter()
        while not _answers(port):
            time.sleep(0.05)
        yield "until it answers", time.perf_counter() - began, "s"
    finally:
        server.terminate()
        server.wait(10)


def _answers(port: int) -> bool:
    try:
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=1)
        connection.request("GET", "/")
        return connection.getresponse().status == 200
    except OSError:
        return False


MEASURED = {one.__name__: one for one in (derivatives, compliant, gaits, proofs, fitting, films, start, lab)}


def main() -> None:
    """Print a row per number."""
    parser = argparse.ArgumentParser(description="How fast everything but the rigid kernel, maps and the page is.")
    parser.add_argument("what", nargs="*", help=f"{', '.join(MEASURED)}; all by default")
    for name in parser.parse_args().what or MEASURED:
        for row, value, unit in MEASURED[name]():
            print(f"{name:12} {row:44} {value:10,.3g} {unit}", flush=True)


if __name__ == "__main__":
    main()
