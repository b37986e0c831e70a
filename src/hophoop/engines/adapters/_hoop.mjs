// Shared by the adapters in JavaScript: the task from standard input, the loop, and the record on standard output.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import path from "node:path";

export const task = JSON.parse(readFileSync(0, "utf8"));
const require = createRequire(path.join(process.cwd(), "index.js"));

/** An engine installed by npm in the folder that the adapter runs in. */
export async function load(name) {
  return import(pathToFileURL(require.resolve(name)).href);
}

/** Version of an installed package. */
export function version(name) {
  let folder = path.dirname(require.resolve(name));
  while (true) {
    try {
      const found = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
      if (found.name === name) return found.version;
    } catch {}
    const above = path.dirname(folder);
    if (above === folder) return "unknown";
    folder = above;
  }
}

/**
 * Step to the end and write the record. `read` gives place, turn (counterclockwise) and velocities of the centre of gravity.
 */
export function march(step, read, notes, began = performance.now()) {
  const { dt, duration, every, radius } = task;
  const arm = task.eccentricity * radius;
  const steps = Math.ceil(duration / dt - 1e-9);
  const rows = [];
  const keep = (i) => {
    const [x, y, turn, vx, vy, spin] = read();
    const omega = -spin;
    const sine = Math.sin(-turn), cosine = Math.cos(turn);
    rows.push([i * dt, x - arm * sine, y - radius - arm * cosine, -turn, vx - arm * omega * cosine, vy + arm * omega * sine, omega]);
  };
  keep(0);
  for (let i = 1; i <= steps; i++) {
    step();
    if (i % every === 0) keep(i);
  }
  const wall = (performance.now() - began) / 1000;
  const head = { ...notes, steps, wall_seconds: wall };
  const lines = Object.entries(head).map(([key, value]) => `# ${key}: ${value}`);
  process.stdout.write(`${lines.join("\n")}\nt,x,y,theta,vx,vy,omega\n${rows.map((row) => row.join(",")).join("\n")}\n`);
}
