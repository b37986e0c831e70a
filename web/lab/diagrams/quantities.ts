// What can stand on the axes of diagrams and in the columns of the table: each quantity of a motion with its unit.

import { DEGREE } from "../common/numbers.ts";

interface Quantity {
  name: string; // in English
  symbol: string;
  unit: string;
  values: (film: Film) => Column;
}

const plain = (column: string) => (film: Film) => film.columns[column];

const made =
  (key: string, of: (columns: Named<Column>, i: number, film: Film) => number): ((film: Film) => Column) =>
  (film) =>
    film.derived(key, (columns) => Float64Array.from(film.t, (_, i) => of(columns, i, film)));

export const QUANTITIES: Named<Quantity> = {
  time: { name: "column.time", symbol: "t", unit: "s", values: (film) => film.t },
  angle: { name: "column.angle", symbol: "θ", unit: "°", values: made("degrees", ({ angle }, i) => angle[i] / DEGREE) },
  turns: {
    name: "column.angle_in_revolution",
    symbol: "column.theta_mod_360",
    unit: "°",
    // no line leads from one turn to the next
    values: made("within", ({ angle }, i) => {
      const turn = (k: number) => Math.floor(angle[k] / DEGREE / 360);
      return i > 0 && turn(i) !== turn(i - 1) ? Number.NaN : angle[i] / DEGREE - 360 * turn(i);
    }),
  },
  x: { name: "column.displacement", symbol: "x", unit: "m", values: plain("x") },
  height: { name: "column.gap", symbol: "y", unit: "m", values: plain("height") },
  rise: {
    name: "column.center_of_gravity_height",
    symbol: "h_G",
    unit: "m",
    values: made(
      "rise",
      ({ height, angle }, i, film) => film.radius * (1 + film.eccentricity * Math.cos(angle[i])) + height[i],
    ),
  },
  vx: { name: "column.speed", symbol: "v", unit: "m/s", values: plain("vx") },
  rotation: {
    name: "column.circumferential_speed",
    symbol: "R θ̇",
    unit: "m/s",
    values: made("rotation", ({ omega }, i, film) => omega[i] * film.radius),
  },
  vy: { name: "column.normal_speed", symbol: "ẏ", unit: "m/s", values: plain("vy") },
  slip: { name: "column.slip_velocity", symbol: "v_t", unit: "m/s", values: plain("slip") },
  omega: { name: "column.angular_velocity", symbol: "θ̇", unit: "rad/s", values: plain("omega") },
  normal_force: { name: "column.normal_force", symbol: "N", unit: "N", values: plain("normal_force") },
  friction_force: { name: "column.friction_force", symbol: "F", unit: "N", values: plain("friction_force") },
  utilization: { name: "column.utilization", symbol: "|F|/μN", unit: "", values: plain("utilization") },
  kinetic: { name: "column.kinetic_energy", symbol: "W_k", unit: "J", values: plain("kinetic") },
  potential: { name: "column.potential_energy", symbol: "W_p", unit: "J", values: plain("potential") },
  total: {
    name: "column.total_energy",
    symbol: "W",
    unit: "J",
    values: made("total", ({ kinetic, potential }, i) => kinetic[i] + potential[i]),
  },
  friction_loss: { name: "curve.friction_loss", symbol: "W_f", unit: "J", values: plain("friction_loss") },
  normal_loss: { name: "curve.normal_loss", symbol: "W_i", unit: "J", values: plain("normal_loss") },
  rolling_resistance: {
    name: "curve.rolling_resistance",
    symbol: "W_r",
    unit: "J",
    values: plain("rolling_resistance"),
  },
};
