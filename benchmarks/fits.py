"""Fits to drawn records of a known motion: are their errors as large as they say, and are wrong data called wrong?

    python benchmarks/fits.py                        # 100 records of each kind
    python benchmarks/fits.py --sets 10 phone50      # some
    python benchmarks/fits.py --seed 7 --json FILE

Tables have the centre and a marker, both marked to 1 mm; phones the angular velocity to 0.02 rad/s. Their errors are not given.
Each record is fitted as it is, with a radius that is 5 % off, and with times that are.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.tracking import Track
from hophoop.tracking.table import track_of

RADIUS, DURATION, REACH = 0.3, 1.09, 0.9  # m, s, and of the marker over the radius
NOISE, GYROSCOPE = 1e-3, 0.02  # m, rad/s
TRUTH = {"gamma": 0.6, "mu_kinetic": 0.45, "restitution": 0.3}
KINDS = {**{f"table{rate}": rate for rate in (30, 60, 120, 240)}, **{f"phone{rate}": rate for rate in (50, 100, 400)}}
OFF = 0.05
NAMED = {"radius": "radius", "times": "times"}
SURE = 3.0  # errors within which the truth must lie


def drawn(kind: str, seed: int) -> Track:
    """Return one record."""
    rate, random = KINDS[kind], np.random.default_rng([seed, KINDS[kind], kind[0] == "p"])
    motion = hh.simulate(
        hh.Hoop.ideal(TRUTH["gamma"], radius=RADIUS),
        hh.Plane(mu_static=0.55, mu_kinetic=TRUTH["mu_kinetic"], restitution=TRUTH["restitution"]),
        hh.Start.rolling(1.9, angle=0.1),
        DURATION,
    )
    t = np.arange(int(DURATION * rate) + 1) / rate
    state = motion.at(t)
    if kind.startswith("phone"):
        columns = {"omega": state.omega + random.normal(0.01, GYROSCOPE, len(t))}
    else:
        reach, y = REACH * RADIUS, state.height + RADIUS
        columns = {"x": state.x, "y": y}
        columns |= {"marker_x": state.x + reach * np.sin(state.angle), "marker_y": y + reach * np.cos(state.angle)}
        columns = {name: np.round(values + random.normal(0.0, NOISE, len(t)), 5) for name, values in columns.items()}
        towards = np.arctan2(columns["marker_x"] - columns["x"], columns["marker_y"] - columns["y"])
        columns["angle"] = np.unwrap(towards)
    return track_of(t, columns, radius=RADIUS)


def spoiled(track: Track, mistake: str, sign: int) -> Track:
    """Return a record with a radius, or with times, that are 5 % too large or too small."""
    factor = 1.0 + sign * OFF
    return replace(track, radius=factor * track.radius) if mistake == "radius" else replace(track, t=factor * track.t)


def measure(kind: str, sets: int, seed: int, spoilt: int | None = None) -> Iterator[dict[str, Any]]:
    """Yield the fit of each record, as it is and spoiled; spoilt: how many are spoiled, by default all."""
    for k in range(sets):
        track = drawn(kind, seed + k)
        for mistake in ("", *(NAMED if spoilt is None or k < spoilt else ())):
            fit = hh.fit(spoiled(track, mistake, 1 - 2 * ((seed + k) % 2)) if mistake else track)
            said = fit.sentences()
            yield {
                "kind": kind,
                "mistake": mistake,
                "seed": seed + k,
                "values": {name: fit.values[name] for name in TRUTH},
                "errors": {name: fit.error(name) if name in fit.free else None for name in TRUTH},
                "reduced": fit.reduced,
                "good": fit.good,
                "usable": fit.usable,
                "named": bool(mistake) and any(NAMED[mistake] in one for one in said[1:]),
                "sentences": said,
            }


def summary(rows: list[dict[str, Any]]) -> list[str]:
    """Describe the fits of one kind of record."""
    said = []
    right = [row for row in rows if not row["mistake"]]
    for name, truth in TRUTH.items():
        found = np.array([(row["values"][name], row["errors"][name]) for row in right if row["errors"][name]])
        off, errors = found[:, 0] - truth, found[:, 1]
        said.append(
            f"{name:12} pulls {np.mean(off / errors):+.2f} ± {np.std(off / errors):.2f}   "
            f"stated over true {np.median(errors) / np.std(off):.2f}   in {len(found)} of {len(right)}"
        )
    for mistake in ("", *NAMED):
        own = [row for row in rows if row["mistake"] == mistake]
        if not own:
            continue
        believed = [row for row in own if row["usable"]]
        sure = sum(all(within(row, name) for name in TRUTH) for row in believed)
        chi = np.quantile([row["reduced"] for row in own], [0.0, 0.5, 1.0])
        said.append(
            f"{mistake or 'right':12} explained {sum(row['good'] for row in own)} of {len(own)}, χ² each "
            f"{chi[1]:.2f} ({chi[0]:.2f} to {chi[2]:.2f}), truth in {sure} of {len(believed)} that are not wrong"
            + (f", named in {sum(row['named'] for row in own)}" if mistake else "")
        )
    return said


def within(row: dict[str, Any], name: str) -> bool:
    """Return True if a value lies within three errors of the truth, or was not determined."""
    error = row["errors"][name]
    return error is None or abs(row["values"][name] - TRUTH[name]) < SURE * error


def main() -> None:
    """Print the measures of each kind of record."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=f"of {', '.join(KINDS)}")
    parser.add_argument("--sets", type=int, default=100, help="records of each kind")
    parser.add_argument("--seed", type=int, default=0, help="of the first record")
    parser.add_argument("--json", type=Path, help="file for each fit")
    given = parser.parse_args()
    found = []
    for kind in given.kinds or KINDS:
        rows = list(measure(kind, given.sets, given.seed))
        print(f"{kind}, {given.sets} records from seed {given.seed}", *summary(rows), sep="\n  ", flush=True)
        found += rows
    if given.json is not None:
        given.json.write_text(json.dumps(found), encoding="utf-8")


if __name__ == "__main__":
    main()
