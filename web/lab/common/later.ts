// Parts of the page that come when they are first asked for: files beside the script; a notebook's single file holds them.

const beside = (name: string) => new URL(`${name}?${STAMP}`, import.meta.url).href;

export const space = (): Promise<typeof import("../player/stage3d.ts")> =>
  APART ? import(beside("stage3d.js")) : import("../player/stage3d.ts");

export const lines = (): Promise<typeof import("../player/svg.ts")> =>
  APART ? import(beside("svg.js")) : import("../player/svg.ts");

export const boundaries = (): Promise<typeof import("../map/boundaries.ts")> =>
  APART ? import(beside("boundaries.js")) : import("../map/boundaries.ts");

/** What has been asked for, or that there is no network to bring it. */
export const fetched = <Part>(part: Promise<Part>) =>
  part.catch(() => {
    throw new Error("page.not_loaded");
  });
