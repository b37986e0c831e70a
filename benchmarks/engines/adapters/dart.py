"""DART: a sphere on a box, on a planar joint."""

from __future__ import annotations

import dartpy as dart
from task import States, Task


def run(task: Task, dt: float, detector: str = "", solver: str = "") -> States:
    """Run a task with a collision detector and a solver of boxed LCPs of DART's."""
    world = dart.simulation.World("hoop")
    world.setTimeStep(dt)
    along, off = task.pull
    world.setGravity([along, off, 0.0])
    if solver:
        world.getConstraintSolver().setBoxedLcpSolver(getattr(dart.constraint, solver)())
    if detector:
        world.getConstraintSolver().setCollisionDetector(getattr(dart.collision, f"{detector}CollisionDetector")())
    dynamics = dart.dynamics
    hoop, ground = dynamics.Skeleton("hoop"), dynamics.Skeleton("ground")
    _, body = hoop.createPlanarJointAndBodyNodePair()
    moment = task.inertia
    inertia = dynamics.Inertia(task.mass, [0.0, task.arm, 0.0], [[moment, 0, 0], [0, moment, 0], [0, 0, moment]])
    body.setInertia(inertia)
    rim = body.createShapeNode(dynamics.SphereShape(task.radius))
    _, block = ground.createWeldJointAndBodyNodePair()
    slab = block.createShapeNode(dynamics.BoxShape([200.0, 1.0, 10.0]))
    slab.setRelativeTranslation([0.0, -0.5, 0.0])
    for node, friction, restitution in ((rim, task.mu, task.restitution), (slab, max(task.mu, 1.0), 1.0)):
        node.createCollisionAspect()
        aspect = node.createDynamicsAspect()
        aspect.setFrictionCoeff(friction)
        aspect.setRestitutionCoeff(restitution)
    world.addSkeleton(ground)
    world.addSkeleton(hoop)
    hoop.setPositions([task.x, task.radius + task.height, -task.angle])
    hoop.setVelocities([task.vx, task.vy, -task.omega])

    def read() -> tuple[float, ...]:
        (x, y, turn), (vx, vy, spin) = hoop.getPositions(), hoop.getVelocities()
        return x, y - task.radius, -turn, vx, vy, -spin

    return task.march_rim(dt, world.step, read)
