// How the kernel's numbers of a scenario change with one parameter, whatever else moves with it: a rolling start goes on
// rolling, the ideal hoop stays ideal. All of them are of second degree in the parameter but for the radius in a speed of
// rotation, so that differences over four steps are their rates to rounding.

import { cellOf } from "../kernel/layout.js";
import { InputError, TooMuch } from "./check.js";
import { given } from "./given.js";
import { within } from "./limits.js";
import { asked } from "./request.js";

/** How far, and the weight of the difference there. @typedef {[number, number][]} Stencil */
/** @type {Stencil} */
const AROUND = [
  [-2, 1 / 12],
  [-1, -2 / 3],
  [1, 2 / 3],
  [2, -1 / 12],
];
/** @type {Stencil} */
const UPWARD = [
  [1, 4],
  [2, -3],
  [3, 4 / 3],
  [4, -1 / 4],
];
/** @type {Stencil} */
const DOWNWARD = UPWARD.map(([far, weight]) => [-far, -weight]);
const RELATIVE = 1e-3;
const LEAST = 1e-6;

/**
 * @param {any} scenario
 * @param {string} path of the parameter
 * @param {number} value that it has
 * @param {Mechanics} mechanics
 * @returns {{ rates: Float64Array, smaller: boolean, larger: boolean } | null} the rates of a cell, and to which sides the
 *   parameter may go; null where it may go to neither
 */
export function ratesOf(scenario, path, value, mechanics) {
  const at = (/** @type {number} */ other) => {
    try {
      return cellOf(given(within(asked({ scenario, changes: [[path, other]] }, mechanics))));
    } catch (error) {
      if (error instanceof InputError || error instanceof TooMuch) return null;
      throw error;
    }
  };
  for (let step = RELATIVE * Math.max(Math.abs(value), 1); step > LEAST * RELATIVE; step *= 0.1) {
    const [smaller, larger] = [-1, 1].map((side) => at(value + side * LEAST * step) !== null);
    for (const stencil of [AROUND, UPWARD, DOWNWARD]) {
      const cells = stencil.map(([far]) => at(value + far * step));
      if (cells.some((cell) => cell === null)) continue;
      return { rates: summed(/** @type {Float64Array[]} */ (cells), stencil, step, at(value)), smaller, larger };
    }
  }
  return null;
}

/**
 * @param {Float64Array[]} cells
 * @param {Stencil} stencil
 * @param {number} step
 * @param {Float64Array | null} base
 */
function summed(cells, stencil, step, base) {
  return Float64Array.from(cells[0], (_, field) => {
    const here = base ? base[field] : cells[0][field];
    // infinite friction stays so
    return (
      cells.reduce((sum, cell, k) => (cell[field] === here ? sum : sum + stencil[k][1] * (cell[field] - here)), 0) /
      step
    );
  });
}
