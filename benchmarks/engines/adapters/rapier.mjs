// Rapier 2D: a ball on a half space, in single precision.
import RAPIER from "@dimforge/rapier2d-compat";
import { march, task } from "./_hoop.mjs";

await RAPIER.init();
const began = performance.now();
const { settings, gravity_center: start } = task;
const world = new RAPIER.World({ x: task.gravity_along, y: task.gravity_off });
world.timestep = task.dt;
if (settings.iterations) world.numSolverIterations = settings.iterations;
if (settings.internal) world.integrationParameters.numInternalPgsIterations = settings.internal;
if (settings.frequency) world.integrationParameters.contact_natural_frequency = settings.frequency;
if (settings.allowed !== undefined) world.integrationParameters.normalizedAllowedLinearError = settings.allowed;
if (settings.prediction !== undefined) world.integrationParameters.normalizedPredictionDistance = settings.prediction;
const { Multiply, Max } = RAPIER.CoefficientCombineRule;
const surface = (desc, mu, e) =>
  desc.setFriction(mu).setRestitution(e).setFrictionCombineRule(Multiply).setRestitutionCombineRule(Max);
world.createCollider(surface(RAPIER.ColliderDesc.halfspace({ x: 0, y: 1 }), 1, 0));
const body = world.createRigidBody(
  RAPIER.RigidBodyDesc.dynamic()
    .setTranslation(start.x, start.y).setRotation(start.turn).setLinvel(start.vx, start.vy).setAngvel(start.spin)
    .setCanSleep(false).setLinearDamping(0).setAngularDamping(0)
    .setAdditionalMassProperties(task.mass, { x: 0, y: 0 }, task.inertia),
);
const rim = RAPIER.ColliderDesc.ball(task.radius).setTranslation(0, -task.eccentricity * task.radius).setDensity(0);
world.createCollider(surface(rim, task.mu, task.restitution), body);
let turn = start.turn, last = start.turn;
march(
  () => {
    world.step();
    const now = body.rotation();
    turn += now - last - 2 * Math.PI * Math.round((now - last) / (2 * Math.PI));
    last = now;
  },
  () => {
    const p = body.translation(), v = body.linvel();
    return [p.x, p.y, turn, v.x, v.y, body.angvel()];
  },
  began,
);
