// A scenario as the numbers that the kernel takes.

export function given({ duration, hoop, plane, start, contact }: Checked): Given {
  const { radius, mass, eccentricity, inertia_ratio } = hoop;
  const { mu, apart, ...ofPlane } = plane;
  const { x, height, angle, vx, vy, omega, slip } = stateOf(start, radius);
  const { max_events, model, ...rest } = contact;
  return {
    radius,
    mass,
    eccentricity,
    inertia_ratio,
    ideal: hoop.load_fraction !== null,
    ...ofPlane,
    x,
    height,
    angle,
    vx,
    vy,
    omega,
    slip,
    rolling: start.speed !== null,
    duration,
    max_events,
    contact: model === "rigid" ? null : (rest as unknown as GivenContact),
  };
}

/**
 * The start as numbers, as Python's `Start.state`: a rolling one turns with its speed over the radius and does not
 * slip.
 */
export function stateOf({ x, height, angle, speed, vx, vy, omega }: CheckedStart, radius: number) {
  const turning = speed === null ? Number(omega) : speed / radius;
  return { x, height, angle, vx, vy, omega: turning, slip: speed === null ? vx - radius * turning : 0 };
}
