"""An engine for rolling hoops as a command of `hophoop compare`."""

import json
import math
import sys

task = json.load(sys.stdin)
radius, arm, mass = (
    task["radius"],
    task["eccentricity"] * task["radius"],
    task["mass"],
)
x, angle, omega, dt = task["x"], task["angle"], task["omega"], task["dt"]
print("# version: 1.0")
print("t,x,y,theta,vx,vy,omega")
for k in range(math.ceil(task["duration"] / dt - 1e-9) + 1):
    if k % task["every"] == 0:
        print(f"{k * dt},{x},0,{angle},{radius * omega},0,{omega}")
    # moment about the point of contact: inertia there changes as the hoop turns
    inertia = task["inertia"] + mass * (
        radius**2 + arm**2 + 2 * radius * arm * math.cos(angle)
    )
    torque = mass * arm * math.sin(angle) * (task["gravity"] + radius * omega**2)
    omega += dt * torque / inertia
    angle += dt * omega
    x += dt * radius * omega
