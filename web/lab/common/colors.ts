// Colours: how light they are, what can be read on them, and those of speed.

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
    lighter = `#${parsed(color)
      .map((value) =>
        Math.round(value + (255 - value) * share)
          .toString(16)
          .padStart(2, "0"),
      )
      .join("")}`;
  }
  return lighter;
}

// Viridis, from nine of its colours.
const VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];

function viridis() {
  const colors = [];
  for (let k = 0; k < 256; k++) {
    const place = (k / 255) * (VIRIDIS.length - 1);
    const low = Math.min(Math.floor(place), VIRIDIS.length - 2);
    const one = parsed(VIRIDIS[low]);
    const two = parsed(VIRIDIS[low + 1]);
    colors.push(one.map((value, i) => Math.round(value + (two[i] - value) * (place - low))));
  }
  return colors;
}

export const SPEED_COLORS = viridis();

export const SPEED_TEXTS = SPEED_COLORS.map((color) => `rgb(${color.join(",")})`);
export const SPEED_GRADIENT = `linear-gradient(90deg, ${SPEED_TEXTS.filter((_, k) => k % 15 === 0).join(",")})`;

// What tells two hoops apart, beside their letters; neither is the colour of a mode or of a quantity.
const HOOP_INKS = ["#123a8c", "#8a6d00"];

export const hoopInk = (lane: number, dark: boolean) => readable(HOOP_INKS[lane], dark);
