"""How fast a fit is: 240 frames, seven parameters, all of `hophoop.fit` once the compiled kernel is loaded.

Seconds depend on what else the machine does; so each fit is also told in motions: `simulate()` and their places in all frames,
timed in turn with the fits.
"""

import os
import sys
import time

import numpy as np

import hophoop as hh
from hophoop.tracking.table import track_of

TARGET = 1.0  # [s]
PLANE = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
SCENARIO = hh.Scenario(hoop=hh.Hoop.ideal(0.6, radius=0.3), plane=PLANE, start=hh.Start.rolling(1.9, angle=0.1), duration=1.01)


def track(seed):
    motion = hh.simulate(SCENARIO)
    t, rng = np.arange(240) / 240, np.random.default_rng(seed)
    state = motion.at(t)
    columns = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    columns = {name: values + rng.normal(0, 1e-3, 240) for name, values in columns.items()}
    columns |= {f"sigma_{name}": np.full(240, 1e-3) for name in columns}
    return track_of(t, columns, radius=0.3, placed=True)


def timed(action, times=1):
    """Seconds on the clock, and of the processor."""
    begin, busy = time.perf_counter(), time.process_time()
    for _ in range(times):
        action()
    return (time.perf_counter() - begin) / times, (time.process_time() - busy) / times


if __name__ == "__main__":
    os.environ.setdefault("HOPHOOP_KERNELS", "compiled")
    hh.fit(track(0))
    fits, motions, computed = [], [], []
    for seed in range(1, 11):
        data = track(seed)
        fits.append(timed(lambda data=data: computed.append(hh.fit(data))))
        motions.append(timed(lambda: hh.simulate(SCENARIO).at(np.arange(240) / 240), 50))
        assert len(computed[-1].free) == 7
    wall, work = np.median(fits, axis=0)
    ratios = np.array(fits)[:, 1] / np.array(motions)[:, 1]
    calls = np.median([found.calls for found in computed])
    print(
        f"{wall:.2f} s a fit (target {TARGET:.0f} s), {work:.2f} s of processor time: that of {np.median(ratios):.0f} motions"
    )
    print(f"with 240 places each; {calls:.0f} motions were computed, beside their derivatives")
    sys.exit(bool(work > TARGET))
