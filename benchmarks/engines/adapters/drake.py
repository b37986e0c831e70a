"""Drake: a sphere on a half space, on a planar joint."""

from __future__ import annotations

from pydrake import geometry, math
from pydrake.multibody import plant as plants
from pydrake.multibody import tree
from pydrake.systems import analysis, framework
from task import States, Task


def run(
    task: Task,
    dt: float,
    approximation: str = "",
    stiffness: float | None = None,
    dissipation: float | None = None,
    stiction: float = 1e-3,
    relaxation: float | None = None,
) -> States:
    """Run a task: stiffness of the contact [N/m], Hunt and Crossley's dissipation [s/m], stiction tolerance [m/s]."""
    builder = framework.DiagramBuilder()
    plant, _ = plants.AddMultibodyPlantSceneGraph(builder, time_step=dt)
    if approximation:
        plant.set_discrete_contact_approximation(getattr(plants.DiscreteContactApproximation, f"k{approximation.title()}"))
    plant.set_contact_model(plants.ContactModel.kPoint)
    plant.set_stiction_tolerance(stiction)
    inertia = tree.UnitInertia(*(task.inertia / task.mass,) * 3).ShiftFromCenterOfMass([0.0, task.arm, 0.0])
    body = plant.AddRigidBody("hoop", tree.SpatialInertia(task.mass, [0.0, task.arm, 0.0], inertia))
    joint = plant.AddJoint(tree.PlanarJoint("plane", plant.world_frame(), body.body_frame()))
    surface = geometry.ProximityProperties()
    geometry.AddContactMaterial(
        friction=plants.CoulombFriction(task.mu, task.mu),
        properties=surface,
        **({} if dissipation is None else {"dissipation": dissipation}),
        **({} if stiffness is None else {"point_stiffness": 2.0 * stiffness}),
    )
    if relaxation is not None:
        surface.AddProperty("material", "relaxation_time", relaxation)
    half = geometry.HalfSpace.MakePose([0.0, 1.0, 0.0], [0.0, 0.0, 0.0])
    plant.RegisterCollisionGeometry(plant.world_body(), half, geometry.HalfSpace(), "ground", surface)
    plant.RegisterCollisionGeometry(body, math.RigidTransform(), geometry.Sphere(task.radius), "rim", surface)
    along, off = task.pull
    plant.mutable_gravity_field().set_gravity_vector([along, off, 0.0])
    plant.Finalize()
    diagram = builder.Build()
    simulator = analysis.Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    joint.set_translation(context, [task.x, task.radius + task.height])
    joint.set_rotation(context, -task.angle)
    joint.set_translational_velocity(context, [task.vx, task.vy])
    joint.set_angular_velocity(context, -task.omega)
    simulator.Initialize()
    clock = iter(range(1, task.steps(dt) + 1))

    def read() -> tuple[float, ...]:
        x, y, turn, vx, vy, spin = plant.GetPositionsAndVelocities(context)
        return x, y - task.radius, -turn, vx, vy, -spin

    return task.march_rim(dt, lambda: simulator.AdvanceTo(next(clock) * dt), read)
