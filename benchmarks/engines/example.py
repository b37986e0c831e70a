"""A penalty method that writes a record of each motion, for score.py.

python benchmarks/engines/example.py records              # --only hop: one motion
python benchmarks/engines/score.py records/*.csv
"""

import argparse
import json
import math
from pathlib import Path

TRUTH = Path(__file__).parent / "data" / "hophoop-bench-1.json"
STEP, STIFFNESS, SLIP_SPEED = 1e-4, 1e6, 1e-3  # s, N/m, m/s


def steps_of(task):
    radius, mass, inertia = task["radius"], task["mass"], task["inertia"]
    arm = task["eccentricity"] * radius
    # what explicit steps of this size can follow
    stiffness = min(STIFFNESS, mass / (3 * STEP) ** 2)
    slip_speed = max(SLIP_SPEED, 10 * STEP)
    # of the centre of gravity; turn is counterclockwise
    x, y, turn, vx, vy, spin = task["gravity_center"].values()
    for k in range(math.ceil(task["duration"] / STEP) + 1):
        # of the rim's centre, which is at the height radius + gap
        sine, cosine, omega = math.sin(-turn), math.cos(turn), -spin
        gap = y - radius - arm * cosine
        along, rise = vx - arm * omega * cosine, vy + arm * omega * sine
        yield k * STEP, x - arm * sine, gap, -turn, along, rise, omega
        damping = math.sqrt(stiffness * mass)
        normal = max(0.0, -stiffness * gap - damping * rise) if gap < 0 else 0.0
        slip = (along - radius * omega) / slip_speed
        friction = -task["mu"] * normal * max(-1.0, min(1.0, slip))
        torque = (radius + arm * cosine) * friction - arm * sine * normal
        vx += STEP * (friction / mass + task["gravity_along"])
        vy += STEP * (normal / mass + task["gravity_off"])
        spin += STEP * torque / inertia
        x, y, turn = x + STEP * vx, y + STEP * vy, turn + STEP * spin


motions = json.loads(TRUTH.read_text("utf-8"))["scenarios"]
parser = argparse.ArgumentParser()
parser.add_argument("folder", type=Path)
parser.add_argument("--only", nargs="+", choices=motions, default=motions)
given = parser.parse_args()
given.folder.mkdir(exist_ok=True)
for name in given.only:
    with (given.folder / f"{name}.csv").open("w") as record:
        print("# engine: penalty method\nt,x,y,theta,vx,vy,omega", file=record)
        for row in steps_of(motions[name]["task"]):
            print(*row, sep=",", file=record)
