// Whether the motions here have the same bits as elsewhere: presets as in Python, links as where they were made.

import { tables } from "../model/tables.js";

const SAME = { python: "✓ Same bits as in Python", link: "✓ Same bits as where the link was made" };
const OTHER = {
  python: "The bits differ: {own} here, {other} in Python.",
  link: "The bits differ: {own} here, {other} where the link was made, perhaps with another version.",
};

/** @typedef {{ same: boolean, text: Said }} Comparison */

export class Sameness {
  /** @param {Preset[]} presets */
  constructor(presets) {
    this.python = new Map(presets.map(({ key, query }) => [query, tables.fingerprints[key]]));
    /** By the query of the motion. @type {Map<string, string>} */
    this.link = new Map();
  }

  /**
   * What a link carries, in the order of its motions.
   * @param {Film[]} films
   * @param {string[]} fingerprints
   */
  expect(films, fingerprints) {
    for (const [k, { query }] of films.entries()) {
      if (fingerprints[k]) this.link.set(query, fingerprints[k]);
    }
  }

  /**
   * What the link said of the motions that are shown, to stay in the address of the page.
   * @param {Film[]} films
   */
  expected(films) {
    return films.map(({ query }) => this.link.get(query) ?? "");
  }

  /**
   * @param {Film} film
   * @returns {Comparison[]}
   */
  of({ query, fingerprint: own }) {
    if (!own) return [];
    return /** @type {const} */ (["python", "link"]).flatMap((whose) => {
      const other = this[whose].get(query);
      if (!other) return [];
      const same = own === other;
      return [{ same, text: same ? SAME[whose] : { key: OTHER[whose], values: { own, other } } }];
    });
  }
}
