"""How fast a fit is: 240 frames, seven parameters, all of `hophoop.fit` once the compiled kernel is loaded."""

import os
import sys
import time

import numpy as np

import hophoop as hh
from hophoop.tracking.table import track_of

TARGET = 1.0  # [s]


def track(seed):
    plane = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
    motion = hh.simulate(hh.Hoop.ideal(0.6, radius=0.3), plane, hh.Start.rolling(1.9, angle=0.1), duration=1.01)
    t, rng = np.arange(240) / 240, np.random.default_rng(seed)
    state = motion.at(t)
    columns = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    columns = {name: values + rng.normal(0, 1e-3, 240) for name, values in columns.items()}
    columns |= {f"sigma_{name}": np.full(240, 1e-3) for name in columns}
    return track_of(t, columns, radius=0.3, placed=True)


if __name__ == "__main__":
    os.environ.setdefault("HOPHOOP_KERNELS", "compiled")
    hh.fit(track(0))
    wall, work = [], []
    for seed in range(1, 11):
        data = track(seed)
        begin, busy = time.perf_counter(), time.process_time()
        found = hh.fit(data)
        wall.append(time.perf_counter() - begin)
        work.append(time.process_time() - busy)
        assert len(found.free) == 7
    print(f"{np.median(wall):.2f} s a fit (target {TARGET:.0f} s), {np.median(work):.2f} s of processor time")
    sys.exit(np.median(wall) > TARGET)
