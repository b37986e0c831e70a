// Whether the motions here have the same bits as elsewhere: presets as in Python, links as where they were made.

import { tables } from "../../model/tables.ts";

const SAME = { python: "fingerprint.same_as_python", link: "fingerprint.same_as_link" };
const OTHER = { python: "fingerprint.not_as_python", link: "fingerprint.not_as_link" };

/** `asked`: by a link. */
export type Comparison = { same: boolean; asked: boolean; text: Message };

export class Sameness {
  /** By the query of the motion. */
  link = new Map<string, string>();
  python: Map<string, string>;

  constructor(presets: Preset[]) {
    this.python = new Map(presets.map(({ key, query }) => [query, tables.fingerprints[key]]));
  }

  /** What a link carries, in the order of its motions. */
  expect(films: Film[], fingerprints: string[]) {
    for (const [k, { query }] of films.entries()) {
      if (fingerprints[k]) this.link.set(query, fingerprints[k]);
    }
  }

  /** What the link said of the motions that are shown, to stay in the address of the page. */
  expected(films: Film[]) {
    return films.map(({ query }) => this.link.get(query) ?? "");
  }

  of({ query, fingerprint: own }: Film) {
    return (["python", "link"] as const).flatMap((whose) => {
      const other = this[whose].get(query);
      if (!other) return [];
      const same = own === other;
      return [
        { same, asked: whose === "link", text: same ? SAME[whose] : { key: OTHER[whose], values: { own, other } } },
      ];
    });
  }
}
