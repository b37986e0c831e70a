// Matter: a regular polygon on a rectangle; its lengths are pixels and its times milliseconds.
import Matter from "matter-js";
import { march, task } from "./_hoop.mjs";

const { Engine, Composite, Bodies, Body } = Matter;
const began = performance.now();
const { settings, gravity_center: start } = task;
const scale = settings.pixels ?? 100; // pixels per metre
const ms = 1000 * task.dt;
const engine = Engine.create({
  positionIterations: settings.positionIterations ?? 6,
  velocityIterations: settings.velocityIterations ?? 4,
});
// y points down; forces are mass × gravity × scale per millisecond squared
const pull = Math.hypot(task.gravity_along, task.gravity_off);
Object.assign(engine.gravity, { x: task.gravity_along / pull, y: -task.gravity_off / pull, scale: (pull * scale) / 1e6 });
const surface = { friction: task.mu, frictionStatic: settings.frictionStatic ?? 0.5, slop: settings.slop ?? 0.05 };
const ground = Bodies.rectangle(0, 500, 40000, 1000, { isStatic: true, restitution: 0, ...surface });
const sides = settings.sides ?? 26;
const arm = task.eccentricity * task.radius * scale;
const body = Bodies.polygon(0, 0, sides, task.radius * scale, { frictionAir: 0, restitution: task.restitution, ...surface });
Body.setCentre(body, { x: 0, y: -arm }, true);
Body.setMass(body, task.mass);
Body.setInertia(body, task.inertia * scale * scale);
Body.setPosition(body, { x: start.x * scale, y: -start.y * scale });
Body.setAngle(body, -start.turn);
// Body.setVelocity takes pixels per 1/60 s
const base = 1000 / 60;
Body.setVelocity(body, { x: (start.vx * scale * base) / 1000, y: (-start.vy * scale * base) / 1000 });
Body.setAngularVelocity(body, (-start.spin * base) / 1000);
Composite.add(engine.world, [ground, body]);
march(
  () => Engine.update(engine, ms),
  () => {
    const v = Body.getVelocity(body), rate = 1000 / base / scale;
    const spin = (-Body.getAngularVelocity(body) * 1000) / base;
    return [body.position.x / scale, -body.position.y / scale, -body.angle, v.x * rate, -v.y * rate, spin];
  },
  began,
);
