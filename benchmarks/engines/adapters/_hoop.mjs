// Shared by the adapters in JavaScript: the job from standard input, the loop, and the record on standard output.
import { readFileSync } from "node:fs";

export const task = JSON.parse(readFileSync(0, "utf8"));

/**
 * Step to the end and write the record. `read` gives place, turn (counterclockwise) and velocities of the centre of gravity.
 */
export function march(step, read, began) {
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
  const lines = rows.map((row) => row.join(","));
  process.stdout.write(`# steps: ${steps}\n# wall_seconds: ${wall}\nt,x,y,theta,vx,vy,omega\n${lines.join("\n")}\n`);
}
