// The address of the page: the motions, the time, what is drawn, and the part of the map that is looked at.

import { once } from "../common/dom.ts";
import { clamp } from "../common/clamp.ts";
import { listed } from "../words/words.ts";
import type { Lab } from "./lab.ts";

const LETTERS: [keyof StageOptions, string][] = [
  ["traces", "t"],
  ["forces", "f"],
  ["speed", "c"],
  ["whole", "w"],
  ["three", "3"],
];
const USUAL = "tfc";
const FINGERPRINT = /^[0-9a-f]{16}$/;
const LATE = 3000; // milliseconds until a busy browser has surely gone to another entry of its history
const WAIT = 400; // milliseconds; browsers refuse more than a few changes of the address a second

export interface Shown {
  time?: number;
  options?: Partial<StageOptions>;
  zoom?: number;
  pan?: [number, number]; // how far the picture is moved, in its own width and height
  from?: number[]; // from where it is looked at in space: azimuth, height, distance
  more?: string; // the parameter of which the arrows tell what a little more would do
  map?: { what: string; x: [string, number, number]; y: [string, number, number] };
  everything?: boolean; // not the simple view
  fingerprints?: string[]; // of the motions, as where the link was made; "" where there is none
}

/** What is shown, as the part of a link behind its #; what is as usual is left out. */
export function written(shown: Shown) {
  const { time = 0, options = {}, zoom = 1, pan = [0, 0], from, more, map, everything, fingerprints = [] } = shown;
  const letters = LETTERS.filter(([name]) => options[name]).map(([, letter]) => letter);
  const parts = {
    t: time > 0 && Number(time.toFixed(4)),
    show: letters.join("") !== USUAL && letters.join(""),
    zoom: zoom !== 1 && Number(zoom.toPrecision(3)),
    pan: pan.some((part) => Math.abs(part) > 5e-4) && pan.map((part) => Number(part.toFixed(3))),
    from: from?.map((part) => Number(part.toPrecision(3))),
    more,
    map: map && [map.what, ...map.x, ...map.y],
    view: everything && "everything",
    fingerprint: fingerprints.some(Boolean) && fingerprints,
  };
  const said = Object.entries(parts).filter(([, value]) => (value ?? false) !== false);
  return said.map(([name, value]) => `${name}=${value}`).join("&");
}

/** What a link says of it; what it does not say, or says wrongly, is left out. */
export function readShown(view: string): Shown {
  const parts = new URLSearchParams(view);
  /** So many numbers, or nothing. */
  const numbers = (name: string, count: number) => {
    const found = parts.get(name)?.split(",").map(Number);
    return found?.length === count && found.every(Number.isFinite) ? found : null;
  };
  const shown: Shown = {};
  const [time] = numbers("t", 1) ?? [];
  if (time >= 0) shown.time = time;
  const letters = parts.get("show");
  if (letters !== null) {
    shown.options = Object.fromEntries(LETTERS.map(([name, letter]) => [name, letters.includes(letter)]));
  }
  const [zoom] = numbers("zoom", 1) ?? [];
  if (zoom > 0) shown.zoom = clamp(zoom, 0.05, 60);
  const pan = numbers("pan", 2);
  if (pan) shown.pan = pan.map((part) => clamp(part, -20, 20)) as [number, number];
  const from = numbers("from", 3);
  if (from) shown.from = from;
  const more = parts.get("more");
  if (more) shown.more = more;
  const [what, x, x0, x1, y, y0, y1] = parts.get("map")?.split(",") ?? [];
  const ends = [x0, x1, y0, y1].map(Number);
  if (y1 !== undefined && ends.every(Number.isFinite) && ends[0] < ends[1] && ends[2] < ends[3]) {
    shown.map = { what, x: [x, ends[0], ends[1]], y: [y, ends[2], ends[3]] };
  }
  if (parts.get("view") === "everything") shown.everything = true;
  const fingerprints = parts.get("fingerprint")?.toLowerCase().split(",");
  if (fingerprints) shown.fingerprints = fingerprints.map((text) => (FINGERPRINT.test(text) ? text : ""));
  return shown;
}

/**
 * The parts of an address. A page that is one file has its query behind the # as well, as all else there may be refused:
 * #view?query, or as in earlier links #?query#view and ##view.
 */
export function shownIn({ search, hash }: Pick<Location, "search" | "hash">) {
  const [, view, query, rest] = hash.match(/^#*([^?#]*)\??([^#]*)#?(.*)/) as string[];
  return { query: /^##|\?/.test(hash) ? query : search.slice(1), view: view || rest };
}

/** The two links that an address holds. */
export const queries = () => {
  const { query, view } = shownIn(location);
  const other = new URLSearchParams(view).get("with");
  return [query, ...(other === null ? [] : [other])];
};

// Writes what is shown into the address of the page, and follows the browser's own way back.
export class Address {
  number = history.state?.number ?? 0; // of the step, also after a reload
  held = false; // the address is wrong: it stays, to be corrected, until another motion is a step
  arriving?: () => void; // what hears that the browser is at the lab's own step
  soon = once(() => this.write("same"), WAIT);
  listen = () => this.arrived();

  /** `own`: what the address begins with; nothing where all is behind its #. */
  constructor(
    readonly lab: Pick<Lab, "backend" | "link" | "motions" | "notice">,
    readonly own: string,
  ) {
    addEventListener("popstate", this.listen);
  }

  close() {
    removeEventListener("popstate", this.listen);
  }

  write(step: "same" | "step" | "again" | "travelled") {
    const { motions } = this.lab;
    // what is shown belongs to the entry that is still to come
    if (!motions.lanes.length || (this.arriving && step === "same")) return;
    // a motion that is still in the hand is no step, and must not take the place of the one before
    if (!motions.history.holds(motions.queries())) return;
    if (this.held && (step === "same" || step === "travelled")) return;
    const link = this.lab.link();
    // no query is said as well where it takes the place of one before the #
    const [, query = location.search && "?", view] = link.match(/^(\?[^#]*)?#?(.*)/) as string[];
    const address = this.own ? this.own + link : `#${view}${query}`;
    if (step === "step" || this.held) history.pushState({ number: ++this.number }, "", address);
    else history.replaceState({ number: this.number }, "", address);
    this.held = false;
  }

  /** Links as far as they can be read; what is wrong in them is said, and the address stays as it is. */
  read(links: string[]) {
    const { notice, backend } = this.lab;
    const found = links.map((link) => backend.readable(link));
    const error = found.find((one) => one.error)?.error;
    const foreign = found.flatMap((one) => one.foreign);
    this.held = Boolean(error);
    const said = () => {
      if (error) notice.fail(error, "shell.link_rest");
      else if (foreign.length) notice.say({ key: "shell.link_ignored", values: { names: listed(foreign) } });
    };
    return { links: found.map((one) => one.query), said };
  }

  /** The step that the lab has made is the browser's, too, where it has one. */
  async travel(way: -1 | 1) {
    if (this.number + way < 0) return;
    await new Promise<void>((resolve) => {
      this.arriving = resolve;
      setTimeout(resolve, LATE);
      history.go(way);
    });
    this.arriving = undefined;
  }

  async arrived() {
    const before = this.number;
    this.number = history.state?.number ?? 0;
    const { links: asked, said } = this.read(queries());
    if (this.arriving) this.arriving();
    else if (JSON.stringify(asked) === JSON.stringify(this.lab.motions.queries())) return;
    else if (await this.lab.motions.arrive(asked)) said();
    else if (this.number !== before) history.go(before - this.number); // stay with what is shown
  }
}
