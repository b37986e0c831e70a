// Jolt: a sphere on a box, kept in its plane by the allowed degrees of freedom, in single precision.
import initJolt from "jolt-physics";
import { march, task } from "./_hoop.mjs";

const Jolt = await initJolt();
const began = performance.now();
const { settings, gravity_center: start } = task;
const options = new Jolt.JoltSettings();
options.mMaxWorkerThreads = 0;
const objects = new Jolt.ObjectLayerPairFilterTable(2);
objects.EnableCollision(0, 1);
const phases = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
phases.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
phases.MapObjectToBroadPhaseLayer(1, new Jolt.BroadPhaseLayer(1));
options.mObjectLayerPairFilter = objects;
options.mBroadPhaseLayerInterface = phases;
options.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 2, objects, 2);
const jolt = new Jolt.JoltInterface(options);
const system = jolt.GetPhysicsSystem();
system.SetGravity(new Jolt.Vec3(task.gravity_along, task.gravity_off, 0));
const physics = system.GetPhysicsSettings();
if (settings.velocitySteps) physics.mNumVelocitySteps = settings.velocitySteps;
if (settings.positionSteps) physics.mNumPositionSteps = settings.positionSteps;
if (settings.slop !== undefined) physics.mPenetrationSlop = settings.slop;
if (settings.speculative !== undefined) physics.mSpeculativeContactDistance = settings.speculative;
if (settings.minVelocity !== undefined) physics.mMinVelocityForRestitution = settings.minVelocity;
physics.mAllowSleeping = false;
system.SetPhysicsSettings(physics);
const bodies = system.GetBodyInterface();
const still = Jolt.Quat.prototype.sIdentity();
const slab = new Jolt.BodyCreationSettings(
  new Jolt.BoxShape(new Jolt.Vec3(100, 1, 5), 0.01), new Jolt.RVec3(0, -1, 0), still, Jolt.EMotionType_Static, 0,
);
slab.mFriction = task.mu;
slab.mRestitution = 0;
bodies.AddBody(bodies.CreateBody(slab).GetID(), Jolt.EActivation_DontActivate);
const arm = task.eccentricity * task.radius;
const ball = new Jolt.OffsetCenterOfMassShapeSettings(new Jolt.Vec3(0, arm, 0), new Jolt.SphereShapeSettings(task.radius));
const turn0 = Jolt.Quat.prototype.sRotation(new Jolt.Vec3(0, 0, 1), start.turn);
const place = new Jolt.RVec3(task.x, task.radius + task.height, 0);
const made = new Jolt.BodyCreationSettings(ball.Create().Get(), place, turn0, Jolt.EMotionType_Dynamic, 1);
made.mFriction = task.mu;
made.mRestitution = task.restitution;
made.mLinearDamping = 0;
made.mAngularDamping = 0;
made.mAllowSleeping = false;
made.mAllowedDOFs = Jolt.EAllowedDOFs_Plane2D;
made.mLinearVelocity = new Jolt.Vec3(start.vx, start.vy, 0);
made.mAngularVelocity = new Jolt.Vec3(0, 0, start.spin);
made.mMaxAngularVelocity = 1000;
const body = bodies.CreateBody(made);
const motion = body.GetMotionProperties();
motion.SetInverseMass(1 / task.mass);
motion.SetInverseInertia(new Jolt.Vec3(0, 0, 1 / task.inertia), still);
bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
const angle = () => {
  const q = body.GetRotation();
  return 2 * Math.atan2(q.GetZ(), q.GetW());
};
let turn = start.turn, last = angle();
march(
  () => {
    jolt.Step(task.dt, 1);
    const now = angle();
    turn += now - last - 2 * Math.PI * Math.round((now - last) / (2 * Math.PI));
    last = now;
  },
  () => {
    const p = body.GetCenterOfMassPosition(), v = body.GetLinearVelocity();
    return [p.GetX(), p.GetY(), turn, v.GetX(), v.GetY(), body.GetAngularVelocity().GetZ()];
  },
  began,
);
