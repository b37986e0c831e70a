// Colours: how light they are, what can be read on them, and those of speed.

import { hex } from "../../model/text.ts";

export function parsed(color: string) {
  const value = Number.parseInt(color.slice(1, 7), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

// Dark or light writing, whichever is easier to read on the colour.
export const writing = (color: string) => (luminance(color) > 0.2 ? "#111111" : "#ffffff");

export const faded = (color: string, opacity: number) => `rgba(${parsed(color).join(",")},${opacity})`;

const channel = (value: number) => {
  const share = value / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
};

export function luminance(color: string) {
  const [r, g, b] = parsed(color).map(channel);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** The colour, lightened until a line of it stands out from dark paper; black gives way to ink. */
export function readable(color: string, dark: boolean) {
  if (!dark || !/^#[0-9a-f]{6}$/i.test(color)) return color;
  if (luminance(color) < 0.002) return "#eceef2";
  let lighter = color;
  for (let share = 0; luminance(lighter) < 0.2 && share < 1; share += 0.05) {
    lighter = `#${hex(parsed(color).map((value) => value + (255 - value) * share))}`;
  }
  return lighter;
}

// Viridis, from nine of its colours.
const VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];

export const SPEED_COLORS = Array.from({ length: 256 }, (_, k) => {
  const place = (k / 255) * (VIRIDIS.length - 1);
  const low = Math.min(Math.floor(place), VIRIDIS.length - 2);
  const [one, two] = [low, low + 1].map((step) => parsed(VIRIDIS[step]));
  return one.map((value, i) => Math.round(value + (two[i] - value) * (place - low)));
});

export const SPEED_TEXTS = SPEED_COLORS.map((color) => `rgb(${color.join(",")})`);
export const SPEED_GRADIENT = `linear-gradient(90deg, ${SPEED_TEXTS.filter((_, k) => k % 15 === 0).join(",")})`;

// What tells two hoops apart, beside their letters; neither is the colour of a mode or of a quantity.
const HOOP_INKS = ["#123a8c", "#8a6d00"];

export const hoopInk = (lane: number, dark: boolean) => readable(HOOP_INKS[lane], dark);
