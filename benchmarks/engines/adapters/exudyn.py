"""Exudyn: a disc on a plane by the penalty connector for rolling discs, on a planar body."""

from __future__ import annotations

import math

import exudyn as exu
import numpy as np
from exudyn import itemInterface as items
from task import States, Task


def run(task: Task, dt: float, stiffness: float = 1e5, damping: float = 1e2, zone: float = 1e-2, solver: str = "") -> States:
    """Run a task: stiffness [N/m] and damping [N s/m] of the penalty, slip speed over which friction builds up [m/s]."""
    container = exu.SystemContainer()
    system = container.AddSystem()
    start = task.body()
    along, off = task.pull
    node = system.AddNode(
        items.NodeRigidBody2D(
            referenceCoordinates=[0.0, 0.0, 0.0],
            initialCoordinates=[start.x, start.y, start.turn],
            initialVelocities=[start.vx, start.vy, start.spin],
        )
    )
    body = system.AddObject(items.ObjectRigidBody2D(mass=task.mass, inertia=task.inertia, nodeNumber=node))
    ground = system.AddObject(items.ObjectGround())
    weight = system.AddMarker(items.MarkerBodyMass(bodyNumber=body))
    system.AddLoad(items.LoadMassProportional(markerNumber=weight, loadVector=[along, off, 0.0]))
    plane = system.AddMarker(items.MarkerBodyRigid(bodyNumber=ground, localPosition=[0.0, 0.0, 0.0]))
    rim = system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=[0.0, -task.arm, 0.0]))
    data = system.AddNode(items.NodeGenericData(initialCoordinates=[0.0, 0.0, 0.0], numberOfDataCoordinates=3))
    system.AddObject(
        items.ObjectConnectorRollingDiscPenalty(
            markerNumbers=[plane, rim], nodeNumber=data, discRadius=task.radius, discAxis=[0.0, 0.0, 1.0],
            planeNormal=[0.0, 1.0, 0.0], contactStiffness=stiffness, contactDamping=damping,
            dryFriction=[task.mu, task.mu], dryFrictionProportionalZone=zone, useLinearProportionalZone=True,
        )
    )  # fmt: skip
    kinds = (exu.OutputVariableType.Coordinates, exu.OutputVariableType.Coordinates_t)
    sensors = [
        system.AddSensor(items.SensorNode(nodeNumber=node, outputVariableType=kind, storeInternal=True, writeToFile=False))
        for kind in kinds
    ]
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = task.steps(dt)
    settings.timeIntegration.endTime = task.steps(dt) * dt
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.newton.useModifiedNewton = False
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = dt * task.every(dt)
    chosen = {} if not solver else {"solverType": getattr(exu.DynamicSolverType, solver)}
    done = system.SolveDynamic(settings, **chosen)
    if done is False:
        raise RuntimeError("Exudyn's solver did not reach the end.")
    place, rate = (np.asarray(system.GetSensorStoredData(sensor)) for sensor in sensors)
    if not math.isclose(place[-1, 0], settings.timeIntegration.endTime, rel_tol=0.01):
        raise RuntimeError(f"Exudyn's solver stopped at {place[-1, 0]:.6g} s.")
    return task.states(place[:, 0], np.hstack([place[:, 1:4], rate[:, 1:4]]))
