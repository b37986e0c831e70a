"""The sample record of a phone in the hoop: computed, not measured, in the layout of phyphox.

Usage: python examples/phone_record.py [FILE]   (default: examples/phone/gyroscope.csv)
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import hophoop as hh

FOLDER = Path(__file__).parent / "phone"
RATE, NOISE, OFFSET = 200, 0.02, 0.01  # values per second, rad/s, rad/s
HEAD = '"Time (s)","Gyroscope x (rad/s)","Gyroscope y (rad/s)","Gyroscope z (rad/s)","Absolute (rad/s)"'


def main(file: Path) -> None:
    """Write the record; the phone's screen looks to the viewer, so a hoop that rolls to the right turns about −z."""
    motion = hh.simulate(
        hh.Hoop.ideal(0.6, radius=0.3),
        hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3),
        hh.Start.rolling(1.9, angle=0.1),
        duration=1.01,
    )
    t = np.arange(RATE + 1) / RATE
    rates = np.random.default_rng(1).normal(0.0, NOISE, (len(t), 3))
    rates[:, 2] += OFFSET - motion.at(t).omega
    rows = np.column_stack([t, rates, np.linalg.norm(rates, axis=1)])
    lines = [f"# computed by {Path(__file__).name} and not measured", HEAD]
    lines += [",".join(f"{value:.4f}" for value in row) for row in rows]
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER / "gyroscope.csv")
