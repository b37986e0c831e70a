// Colours and names of the classes of motions in maps: the page's side of vocabulary/classes.py.

import { tables } from "./tables.ts";

const { codes, families, massless, hops, rolls, other } = tables.classes;
const SEQUENCE = "sequence";

/** As Python's zlib.crc32 of ASCII. */
function checksum(text: string) {
  let sum = ~0;
  for (const sign of text) {
    sum ^= sign.charCodeAt(0);
    for (let bit = 0; bit < 8; bit++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

/** `name`: a sequence, or a word of another quantity; returns as #RRGGBB. */
export function classColor(name: string, quantity: string): string {
  if (quantity !== SEQUENCE) return codes[quantity]?.[name] ?? other;
  const first = [...name].find((letter) => "SK".includes(letter)) ?? "R";
  const does = [name.startsWith("R") && "rolls", /[SK]/.test(name) && "slips"].filter(Boolean).join(", ");
  const contact = name.endsWith("H") ? hops : (families[first + name.slice(-1)] ?? rolls);
  const ink = name.includes("M") ? massless[does] : contact;
  const base = [1, 3, 5].map((place) => Number.parseInt(ink.slice(place, place + 2), 16) / 255);
  const middle = (base[0] + base[1] + base[2]) / 3;
  const depth = Math.min(name.length - 1, 9) / 9;
  // classes of one length and family still differ a little, by their names
  const drift = (checksum(name) % 1000) / 1000;
  const light = 0.62 - 0.62 * Math.min(2 * depth, 1);
  const dark = Math.max(2 * depth - 1, 0) * 0.5;
  const shades = base.map((part) => {
    const mixed = (1 - 0.2 * drift) * part + 0.2 * drift * middle;
    const shade = Math.min(Math.max((mixed + (1 - mixed) * light) * (1 - dark), 0), 1);
    return Math.round(255 * shade)
      .toString(16)
      .padStart(2, "0");
  });
  return `#${shades.join("")}`;
}

/** A class in words. */
export function classText(name: string, quantity: string): Said {
  if (quantity !== SEQUENCE) return `class.${name}`;
  const letters = [...name].map((letter) => (letter === "+" ? "…" : `sequence.${letter}`));
  return letters.flatMap((letter, k) => (k ? [" → ", letter] : [letter]));
}
