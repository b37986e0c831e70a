// Mechanics for tests in Node without the module: what Python has computed, looked up, or Python's own sums again.

/** As Python's math.fsum: exact partial sums. */
function fsum(values) {
  const partials = [];
  for (let x of values) {
    let count = 0;
    for (let y of partials) {
      if (Math.abs(x) < Math.abs(y)) [x, y] = [y, x];
      const high = x + y;
      const low = y - (high - x);
      if (low) partials[count++] = low;
      x = high;
    }
    partials.length = count;
    partials.push(x);
  }
  // from the largest down; a half is decided by what follows
  let n = partials.length;
  if (!n) return 0;
  let high = partials[--n];
  let low = 0;
  while (n > 0) {
    const x = high;
    const y = partials[--n];
    high = x + y;
    low = y - (high - x);
    if (low) break;
  }
  if (n > 0 && ((low < 0 && partials[n - 1] < 0) || (low > 0 && partials[n - 1] > 0))) {
    const y = low * 2;
    const x = high + y;
    if (y === x - high) high = x;
  }
  return high;
}

function inertia(part) {
  if (part.shape === "ring") return 0.5 * part.mass * (part.inner_radius ** 2 + part.outer_radius ** 2);
  if (part.shape === "disk") return 0.5 * part.mass * part.radius ** 2;
  return part.shape === "rod" ? (part.mass * part.length ** 2) / 12 : 0;
}

function reach(part) {
  if (part.shape === "ring") return part.outer_radius;
  if (part.shape === "disk") return Math.abs(part.at) + part.radius;
  if (part.shape === "point_mass") return Math.abs(part.at);
  const half = 0.5 * part.length;
  return part.direction === "radial" ? Math.abs(part.at) + half : Math.hypot(part.at, half);
}

function timeUnit({ radius, gravity }) {
  return Math.sqrt(radius / (gravity > 0 ? gravity : 1));
}

export const mechanics = {
  ideal: (gamma) => (1 - gamma) * (1 + gamma),
  resistance: (eps, kap) =>
    eps === 0 ? Infinity : Math.sqrt(((1 - eps) * (1 - eps) + kap) * ((1 + eps) * (1 + eps) + kap)) / eps,
  combine(radius, parts) {
    const mass = fsum(parts.map((part) => part.mass));
    const first = (parts[0].at ?? 0) / radius;
    const offset = fsum(parts.map((part) => part.mass * ((part.at ?? 0) / radius - first))) / mass;
    const centre = first + offset;
    const sum = fsum(
      parts.map((part) => inertia(part) / radius ** 2 + part.mass * ((part.at ?? 0) / radius - centre) ** 2),
    );
    return { mass, eccentricity: Math.min(Math.abs(centre), 1), inertia_ratio: sum / mass, reaches: parts.map(reach) };
  },
  compliance(given) {
    const { radius, mass, contact, height, vx, vy, omega, gravity, duration } = given;
    const second = timeUnit(given);
    const k = contact.stiffness === null ? 1e6 : (contact.stiffness * second ** 2) / mass;
    const fall = gravity > 0 ? Math.sqrt((2 * height) / radius) : 0;
    const speed = ((Math.abs(vx) + Math.abs(vy) + Math.abs(omega) * radius) * second) / radius + fall;
    const rate = 10 / second + (contact.stiffness === null ? 0 : Math.sqrt(contact.stiffness / mass));
    return {
      stiffness: contact.stiffness / (mass / second ** 2),
      tangential_stiffness: contact.tangential_stiffness / (mass / second ** 2),
      slip_speed: contact.slip_speed / (radius / second),
      depth: speed / Math.sqrt(k) + 1 / k,
      steps: 10 * duration * rate,
      automatic: { stiffness: 0, slip_speed: 0 },
    };
  },
};
