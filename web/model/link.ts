// What a link still says where something in it is wrong: parameters of others are ignored, and the rest of it is kept.

import { InputError } from "./check.ts";
import { within } from "./limits.ts";
import { asked } from "./request.ts";
import { tables } from "./tables.ts";

const OWN = new Set(Object.keys(tables.scenario.models.Scenario.fields));
const MOST = 40; // parameters of a link that is searched for those that are right

const nameOf = (pair: string) => new URLSearchParams(`&${pair}`).keys().next().value ?? "";

// Mail programs and networks add such as fbclid or utm_source; the names of a scenario have a dot.
const isForeign = (pair: string) => !nameOf(pair).includes(".") && !OWN.has(nameOf(pair));

/** Returns the link that can be shown, the names of others in it, and what is wrong with the rest. */
export function readable(
  query: string,
  mechanics: Mechanics,
): { query: string; foreign: string[]; error: Error | null } {
  const pairs = query.replace(/^\?/, "").split("&").filter(Boolean);
  const own = pairs.filter((pair) => !isForeign(pair));
  const foreign = pairs.filter(isForeign).map(nameOf);
  const refusal = (some: string[]) => {
    try {
      within(asked({ query: some.join("&") }, mechanics));
      return null;
    } catch (error) {
      if (error instanceof InputError) return error;
      throw error;
    }
  };
  const error = refusal(own);
  const right = error ? rightOf(own, (some) => !refusal(some)) : own;
  return { query: right.join("&"), foreign: [...new Set(foreign)], error };
}

/** As many parameters as go together, looked for in each section by itself. */
function rightOf(pairs: string[], holds: (pairs: string[]) => boolean) {
  if (pairs.length > MOST) return [];
  const sections: Map<string, string[]> = new Map();
  for (const pair of pairs) {
    const section = nameOf(pair).split(".")[0];
    sections.set(section, [...(sections.get(section) ?? []), pair]);
  }
  let right: string[] = [];
  for (const section of sections.values()) {
    const wider = [...right, ...most(section, holds)];
    if (holds(wider)) right = wider;
  }
  return right;
}

/** The section without its wrong parameter, or without its wrong two; nothing of it where there are more. */
function most(pairs: string[], holds: (pairs: string[]) => boolean) {
  const without = (...places: number[]) => pairs.filter((_, place) => !places.includes(place));
  const tries = [
    pairs,
    ...pairs.map((_, i) => without(i)),
    ...pairs.flatMap((_, i) => pairs.map((_, j) => without(i, j))),
  ];
  return tries.find(holds) ?? [];
}
