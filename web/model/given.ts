// A scenario as the numbers that the kernel takes.

const ROUNDED = 1e-9; // of the velocities: within it a start's own slip agrees with them

export function given({ duration, hoop, plane, start, contact }: Checked): Given {
  const { load_fraction, parts, ...ofHoop } = hoop;
  const { mu, ...ofPlane } = plane;
  const { max_events, model, ...rest } = contact;
  return {
    ...ofHoop,
    ideal: load_fraction !== null,
    ...ofPlane,
    ...stateOf(start, hoop.radius),
    rolling: start.speed !== null,
    duration,
    max_events,
    contact: model === "rigid" ? null : rest,
  };
}

/**
 * The start as numbers, as Python's `Start.state`: a rolling one turns with its speed over the radius and does not
 * slip; one that goes on from another motion has the slip and the mode of that.
 */
export function stateOf({ x, height, angle, speed, vx, vy, omega, slip, mode }: CheckedStart, radius: number) {
  const state = { x, height, angle, vx, vy };
  if (speed !== null) return { ...state, omega: speed / radius, slip: 0, mode: null };
  const rim = radius * Number(omega);
  const goesOn = slip !== null && Math.abs(slip - (vx - rim)) <= ROUNDED * (Math.abs(vx) + Math.abs(rim));
  return { ...state, omega: Number(omega), slip: goesOn ? slip : vx - rim, mode: goesOn ? mode : null };
}
