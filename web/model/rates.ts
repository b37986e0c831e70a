// How the numbers of a cell of the kernel change with one parameter, whatever else moves with it – a rolling start goes on
// rolling, the ideal hoop stays ideal –, in Python's order of operations: derivatives/parameters.py.

import { CELL, layout } from "../kernel/layout.ts";
import { stateOf } from "./given.ts";
import { number, tables } from "./tables.ts";

/** Of the cell's numbers, by name; of those that are left out they are 0. */
export type Rates = Record<string, number>;

/** Of the massless hoop: it has its load at the rim, and rolls on a level plane only. */
const FIXED = ["hoop.eccentricity", "plane.slope"];

/** What changes with a parameter; null where the scenario is not given by it, or it is infinite or can be no other. */
const CHANGES: Record<string, (checked: Checked) => Rates | null> = {
  ...Object.fromEntries(Object.entries(tables.map.rates).map(([path, column]) => [path, () => ({ [column]: 1 })])),
  "hoop.radius": ofRadius,
  "hoop.mass": ({ hoop }) => (hoop.parts ? null : { mass: 1 }),
  "hoop.load_fraction": ({ hoop: { load_fraction } }) =>
    load_fraction === null ? null : { eccentricity: 1, inertia_ratio: -2 * load_fraction },
  "plane.mu": ({ plane: { mu } }) => (mu === null || mu === Infinity ? null : { mu_static: 1, mu_kinetic: 1 }),
  "plane.mu_static": ({ plane }) => (plane.mu_static === Infinity ? null : { mu_static: 1 }),
  "plane.mu_kinetic": ({ plane }) => (plane.mu_kinetic === Infinity ? null : { mu_kinetic: 1 }),
  "plane.rolling_resistance": ({ hoop }) => (hoop.inertia_ratio === 0 ? null : { rolling_resistance: 1 }),
  "start.speed": ({ hoop, start }) => (start.speed === null ? null : { omega: 1 / hoop.radius }),
  "start.vx": () => ({ slip: 1 }),
  "start.omega": ({ hoop }) => ({ omega: 1, slip: -hoop.radius }),
};

function ofRadius({ hoop: { radius, parts, eccentricity, inertia_ratio }, start: { speed, omega } }: Checked) {
  const rates: Rates = { radius: 1 };
  if (speed === null) rates.slip = -(omega || 0);
  else rates.omega = -speed / (radius * radius);
  if (!parts) return rates;
  return { ...rates, eccentricity: -eccentricity / radius, inertia_ratio: (-2 * inertia_ratio) / radius };
}

/**
 * `path`: of the parameter; returns the rates of a cell, and to which sides the parameter may go; null where it may
 * go to neither.
 */
export function ratesOf(
  checked: Checked,
  path: string,
): { rates: Float64Array; smaller: boolean; larger: boolean } | null {
  const changes = CHANGES[path]?.(checked);
  const { smaller, larger } = allowedSides(checked, path);
  if (!changes || !(smaller || larger)) return null;
  const rates = new Float64Array(layout.cell.length);
  for (const [name, rate] of Object.entries(changes)) rates[CELL[name]] = rate;
  return { rates, smaller, larger };
}

/** Whether a parameter may be smaller, and whether it may be larger, than it is: Python's `allowed_sides`. */
function allowedSides(checked: Checked, path: string) {
  const { mu_static, mu_kinetic } = checked.plane;
  const value = numberAt(checked, path);
  const { least, most, also = [] } = tables.map.allowed[path];
  const apart = mu_static !== mu_kinetic;
  const fixed = checked.hoop.inertia_ratio === 0 && FIXED.includes(path);
  return {
    smaller: !fixed && value > Math.min(least, ...also.map(number)) && (apart || path !== "plane.mu_static"),
    larger: !fixed && value < most && (apart || path !== "plane.mu_kinetic"),
  };
}

function numberAt(checked: Checked, path: string): number {
  if (path === "start.omega") return stateOf(checked.start, checked.hoop.radius).omega;
  return path.split(".").reduce((node, step) => (node as any)[step], checked as any);
}
