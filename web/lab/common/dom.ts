// Elements of the page. Words follow the language, see words.ts.

import { luminance } from "./colors.ts";
import { hex } from "../../model/text.ts";
import { name as called, spokenText } from "../words/words.ts";

const LETTERS = 14; // pixels, the usual size of letters
const SAID = new Set(["aria-label", "title", "placeholder", "label"]);

type Tags = HTMLElementTagNameMap;
type Made<Name> = Name extends keyof Tags ? Tags[Name] : Name extends `${infer Tag}.${string}` ? Made<Tag> : never;

/** Attributes of an element, not its first child: a phrase has a key. */
const areAttributes = (given: any) => given?.constructor === Object && !("key" in given);

/**
 * An element, by its tag and classes as in `p.hint`, with attributes and listeners (`onclick`) if there are any, and
 * children; what is null or false is left out.
 */
export function h<Name extends keyof Tags | `${keyof Tags}.${string}`>(name: Name, ...given: any[]) {
  const [tag, ...classes] = name.split(".");
  const [attributes, ...children] = areAttributes(given[0]) ? given : [{}, ...given];
  const element = document.createElement(tag);
  element.classList.add(...classes);
  if (tag === "button") element.setAttribute("type", "button");
  const properties = element as unknown as Named;
  for (const [name, value] of Object.entries<any>(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "class") element.className = value;
    else if (SAID.has(name)) called(element, name, value);
    else if (name in element && name !== "list" && typeof value !== "string") properties[name] = value;
    else element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat(2)) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child.nodeType ? child : spokenText(child));
  }
  return element as Made<Name>;
}

/** A button that shows a picture or a sign, and is called otherwise. */
export const iconButton = (sign: Node | string, title: string, onclick: () => void, more: Named = {}) =>
  h("button", { title, "aria-label": title, onclick, ...more }, sign);

/** A choice of one of several values. `words`: for each; `picked`: gets the one that is chosen. */
export function selection<Value extends string | number>(
  values: readonly Value[],
  words: (value: Value) => Message,
  picked: (value: string) => void,
  attributes: Named = {},
) {
  const options = values.map((value) => h("option", { value: String(value) }, words(value)));
  const select = h("select", { ...attributes, onchange: () => picked(select.value) }, options);
  return select;
}

/** The button that closes the dialog in which it is. */
export const closing = () =>
  h("button.close", { onclick: ({ target }: any) => target.closest("dialog").close() }, "table.close");

/** A button that copies a code, or selects it where the browser does not let it. */
export function copying(code: HTMLElement) {
  const button = h("button", "motion.copy");
  button.onclick = async () => {
    try {
      await navigator.clipboard.writeText(code.textContent ?? "");
      say(button, "motion.copied");
    } catch {
      getSelection()?.selectAllChildren(code); // to be copied by hand
    }
  };
  return button;
}

/** An item of a menu, which closes as it is chosen. */
export const menuItem = (words: string, action: () => void, kind = "") =>
  h(
    "button",
    {
      class: kind,
      onclick: ({ target }: any) => {
        target.closest("details").open = false;
        action();
      },
    },
    words,
  );

/** The names of columns. */
export const headed = (...names: Message[]) =>
  h("thead", h("tr", ...names.map((name) => h("th", { scope: "col" }, [name]))));

/** A row of a table with what it is called. */
export const rowOf = (called: any, ...cells: any[]) =>
  h("tr", h("th", { scope: "row" }, called), ...cells.map((cell) => h("td", cell)));

/** Put other words into an element; they change with the language. */
export function say(element: Element, said: Message) {
  if (said) element.replaceChildren(spokenText(said));
  else element.replaceChildren();
}

/** The 2D context of a canvas, which every browser gives unless the canvas is used otherwise. */
export const pen = (canvas: HTMLCanvasElement) => canvas.getContext("2d") as CanvasRenderingContext2D;

/**
 * A canvas as large as its box, in device pixels, and empty; returns its 2D context scaled to CSS pixels, or to a unit
 * of so many.
 */
export function scaledContext(canvas: HTMLCanvasElement, unit = 1) {
  const box = canvas.getBoundingClientRect();
  const ratio = Math.min(globalThis.devicePixelRatio || 1, 2.5);
  const width = Math.max(Math.round(box.width * ratio), 1);
  const height = Math.max(Math.round(box.height * ratio), 1);
  const context = pen(canvas);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const scale = ratio * unit;
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width / scale, height / scale);
  return { context, width: width / scale, height: height / scale };
}

/** A picture of one pixel a cell, by rows from below; a cell without a colour is clear. */
export function cellPicture(columns: number, rows: number, colorOf: (cell: number) => number[] | null) {
  const image = new ImageData(columns, rows);
  for (let cell = 0; cell < columns * rows; cell++) {
    const color = colorOf(cell);
    const place = (rows - 1 - Math.floor(cell / columns)) * columns + (cell % columns);
    if (color) image.data.set([...color, 255], 4 * place);
  }
  const picture = h("canvas", { width: columns, height: rows });
  pen(picture).putImageData(image, 0, 0);
  return picture;
}

/** A colour as #rrggbb, also one that the system names, such as CanvasText. */
function plainColor(color: string) {
  if (/^#[0-9a-f]{6}$/i.test(color)) return color;
  const context = pen(h("canvas", { width: 1, height: 1 }));
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
  return `#${hex([r, g, b])}`;
}

export function theme(element: HTMLElement) {
  const style = getComputedStyle(element);
  const given = (name: string) => style.getPropertyValue(name).trim();
  const read = (name: string) => plainColor(given(name));
  return {
    ink: read("--ink"),
    soft: read("--soft"),
    line: read("--line"),
    paper: read("--paper"),
    panel: read("--panel"),
    ground: read("--ground"),
    accent: read("--accent"),
    font: given("--font"),
    px: Number.parseFloat(style.fontSize) / LETTERS || 1,
    dark: luminance(read("--paper")) < 0.2,
  };
}

export function saveBlob(blob: Blob, name: string) {
  const link = h("a", { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function once(callback: () => void, wait: number) {
  let timer = 0;
  return () => {
    clearTimeout(timer);
    timer = setTimeout(callback, wait);
  };
}

/** What has been asked for, or that there is no network to bring it. */
export const fetched = <Part>(part: Promise<Part>) =>
  part.catch(() => {
    throw new Error("page.not_loaded");
  });
