// What Python knows and the page needs: models and their ranges, sentences, words, presets. `python -m hophoop.lab.tables`
// writes it.

import written from "../../src/hophoop/lab/static/tables.json" with { type: "json" };

export const tables: Tables = written;

/** "inf" of a table is a number. */
export const number = (value: any) => (value === "inf" ? Infinity : value);
