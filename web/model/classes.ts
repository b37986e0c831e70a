// Colours and names of the classes of motions in maps: the page's side of vocabulary/colors.py, to the same digits.

import { tables } from "./tables.ts";

const { codes, families, massless, hops, rolls, other } = tables.classes;
const SEQUENCE = "sequence";

/** From 0 to 1: classes of one length and family differ a little, by their names. */
const driftOf = (name: string) => [...name].reduce((sum, letter) => (131 * sum + letter.charCodeAt(0)) % 997, 0) / 997;

/** `name`: a sequence, or a word of another quantity; returns as #RRGGBB. */
export function classColor(name: string, quantity: string): string {
  if (quantity !== SEQUENCE) return codes[quantity]?.[name] ?? other;
  const first = /[SK]/.exec(name)?.[0] ?? "R";
  const does = [name.startsWith("R") && "rolls", /[SK]/.test(name) && "slips"].filter(Boolean).join(", ");
  const contact = name.endsWith("H") ? hops : (families[first + name.slice(-1)] ?? rolls);
  const ink = name.includes("M") ? massless[does] : contact;
  const base = [1, 3, 5].map((place) => Number.parseInt(ink.slice(place, place + 2), 16) / 255);
  const middle = (base[0] + base[1] + base[2]) / 3;
  const depth = Math.min(name.length - 1, 9) / 9;
  const drift = 0.2 * driftOf(name);
  const light = 0.62 - 0.62 * Math.min(2 * depth, 1);
  const dark = Math.max(2 * depth - 1, 0) * 0.5;
  const shades = base.map((part) => {
    const mixed = (1 - drift) * part + drift * middle;
    const shade = Math.round(255 * (mixed + (1 - mixed) * light) * (1 - dark));
    return shade.toString(16).padStart(2, "0");
  });
  return `#${shades.join("")}`;
}

/** A class in words. */
export function classText(name: string, quantity: string): Message {
  if (quantity !== SEQUENCE) return `class.${name}`;
  const { letters: known, modes } = tables.words;
  const letters = [...name].map((letter) => (letter === "+" ? "…" : `mode.${modes[known.indexOf(letter)]}`));
  return letters.flatMap((letter, k) => (k ? [" → ", letter] : [letter]));
}
