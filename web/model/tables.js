// What Python knows and the page needs: models and their ranges, sentences, words, presets. `python -m hophoop.lab.tables`
// writes it.

import written from "../../src/hophoop/lab/static/tables.json" with { type: "json" };

/** @type {any} */
export const tables = written;

/** "inf" of a table is a number. @param {any} value */
export const number = (value) => (value === "inf" ? Infinity : value);
