export const clamp: (value: number, least: number, most: number) => number = (value, least, most) =>
  Math.min(Math.max(value, least), most);
