// Planck (Box2D's algorithms in JavaScript): a circle on an edge, in double precision.
import { Circle, Edge, Settings, Vec2, World } from "planck";
import { march, task } from "./_hoop.mjs";

const began = performance.now();
const { settings, gravity_center: start } = task;
if (settings.linearSlop !== undefined) Settings.linearSlop = settings.linearSlop;
if (settings.velocityThreshold !== undefined) Settings.velocityThreshold = settings.velocityThreshold;
const world = new World({ gravity: Vec2(task.gravity_along, task.gravity_off), allowSleep: false });
world.createBody().createFixture({ shape: new Edge(Vec2(-100, 0), Vec2(100, 0)), friction: task.mu, restitution: 0 });
const body = world.createBody({
  type: "dynamic", position: Vec2(start.x, start.y), angle: start.turn,
  linearVelocity: Vec2(start.vx, start.vy), angularVelocity: start.spin, allowSleep: false,
});
const arm = task.eccentricity * task.radius;
body.createFixture({
  shape: new Circle(Vec2(0, -arm), task.radius), density: 1, friction: task.mu, restitution: task.restitution,
});
body.setMassData({ mass: task.mass, center: Vec2(0, 0), I: task.inertia });
body.setLinearVelocity(Vec2(start.vx, start.vy));
body.setAngularVelocity(start.spin);
const { velocityIterations = 8, positionIterations = 3 } = settings;
march(
  () => world.step(task.dt, velocityIterations, positionIterations),
  () => {
    const p = body.getWorldCenter(), v = body.getLinearVelocity();
    return [p.x, p.y, body.getAngle(), v.x, v.y, body.getAngularVelocity()];
  },
  began,
);
