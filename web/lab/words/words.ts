// The page in other languages. English is the source: a word or sentence in English is the key of its translation, and
// numbers and names in it stand as {places}. What Python writes for the page comes in English as well and is recognised
// by the same keys, so that one file a language holds all of it. `dom.ts` sends every word that it puts on the page
// through `t`; what is drawn on a canvas or set later calls it.

import TABLES from "../../words/tables.ts";
import { recall, remember } from "../shell/memory.ts";

/** Each language's own name for itself. */
const nameOf = (code: string) => {
  const name = new Intl.DisplayNames([code], { type: "language" }).of(code) ?? code;
  return name[0].toLocaleUpperCase(code) + name.slice(1);
};

/** Names by code, English first. */
export const LANGUAGES: Record<string, string> = Object.fromEntries(
  ["en", ...Object.keys(TABLES)].map((code) => [code, nameOf(code)]),
);
const KEY = "hophoop-language";
const MOST = 4000; // sentences that are remembered
const NAMES = /^((\d\S* )?(rad(\/s)?|kg|m\/s²?)|'?[\w.[\]]+\.\w+'?|'\w*'|([\w.]+, )+[\w.]+|hophoop.*)$/u;
const PLACE = /\{(\w+)\}/g;

export type Sentence = { key: string; pattern: RegExp; names: string[] };

let language = "en";
/** Whether decimals follow a comma. */
let commas = false;
let sentences: Sentence[] = [];
let known: Map<string, string> = new Map();
/** What has been said already is not translated again. */
let uttered: Set<string> = new Set();
/** Words that were shown without a translation, for the tests. */
export const untranslated: Set<string> = new Set();

export const current = () => language;

/** `code`: one of LANGUAGES. */
export function speak(code: string) {
  language = code in LANGUAGES ? code : "en";
  commas = (1.5).toLocaleString(language).includes(",");
  known = new Map();
  uttered = new Set();
  untranslated.clear();
  sentences = Object.keys(TABLES[language] ?? {})
    .filter((key) => key.includes("{"))
    .map(compiled)
    .sort((a, b) => literal(b.key) - literal(a.key));
}

/** The visitor's language: chosen before, else the first of the browser's that there is. */
export function preferred() {
  const kept = recall(KEY);
  if (kept && kept in LANGUAGES) return kept;
  const tags = globalThis.navigator?.languages ?? [];
  const wanted = tags.map((tag) => tag.slice(0, 2).toLowerCase());
  return wanted.find((code) => code in LANGUAGES) ?? "en";
}

export function keep(code: string) {
  remember(KEY, code);
}

const literal = (key: string) => key.replace(PLACE, "").length;

function compiled(key: string): Sentence {
  const names = [...key.matchAll(PLACE)].map(([, name]) => name);
  const parts = key.split(/\{\w+\}/).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  return { key, names, pattern: new RegExp(`^${parts.join("(.+?)")}$`, "su") };
}

/** A number as it is written in the language. */
export const local = (text: string) => (commas ? text.replace(/(\d)\.(\d)/g, "$1,$2") : text);

/**
 * A text in the language of the page; what it does not know stays as it is. `text`: in English; `values`: what stands
 * in its {places}.
 */
export function t(text: string, values?: Record<string, string | number>): string {
  const table = TABLES[language];
  if (values) return utter(filled(table?.[text] ?? missing(text), values));
  if (!table || !/\p{L}/u.test(text)) return local(text);
  if (uttered.has(text)) return text;
  const found = known.get(text);
  if (found !== undefined) return found;
  const trimmed = text.trim();
  const translated = table[trimmed] ?? recognised(trimmed, table) ?? missing(trimmed);
  const whole = text.replace(trimmed, () => translated);
  if (known.size > MOST) known.clear();
  known.set(text, whole);
  return utter(whole);
}

/** Marks what has been put together from translated pieces. */
export function utter(text: string) {
  if (uttered.size > MOST) uttered.clear();
  uttered.add(text);
  return text;
}

/** A sentence with its values, still in English: what stands on the page so follows the language. */
export const english = (text: string, values: Record<string, string | number>) =>
  text.replace(PLACE, (_, name) => String(values[name]));

/** Words of the scenario's own, such as 'flight', stay as they are. */
const filled = (template: string, values: Record<string, string | number>) =>
  template.replace(PLACE, (_, name) => (name.startsWith("word") ? String(values[name]) : t(String(values[name]))));

function recognised(text: string, table: Record<string, string>) {
  for (const { key, pattern, names } of sentences) {
    const match = text.match(pattern);
    if (match) return filled(table[key], Object.fromEntries(names.map((name, i) => [name, match[i + 1]])));
  }
  return listed(text);
}

/** Phases in a row, as maps name them. */
function listed(text: string) {
  if (!text.includes(" → ")) return undefined;
  return text
    .split(" → ")
    .map((part) => t(part))
    .join(" → ");
}

/** What Python says of a whole motion, 'Rolls, skids at 49.8°, rolls at 152.7°. It has come to rest.' */
export function told(summary: string) {
  if (!TABLES[language]) return summary;
  const [, first, rest] = summary.match(/^(.*?)\.(?: (.*))?$/su) ?? ["", summary, ""];
  const { comma, stop } = language === "zh" ? { comma: "，", stop: "。" } : { comma: ", ", stop: "." };
  const phrases = `${first[0]?.toLowerCase() ?? ""}${first.slice(1)}`.split(/, (?!\d)/).map((phrase) => t(phrase));
  const said = phrases.join(comma);
  return utter(`${said[0]?.toLocaleUpperCase(language) ?? ""}${said.slice(1)}${stop}${rest ? ` ${t(rest)}` : ""}`);
}

function missing(text: string) {
  // symbols, units, and names of the scenario's keys and of its words are the same everywhere
  const words = /\p{L}{3,}/u.test(text) && !NAMES.test(text);
  if (language !== "en" && words && untranslated.size < 200) untranslated.add(text);
  return local(text);
}

/** What stands on the page in English underneath. */
const sources: WeakMap<Node, string> = new WeakMap();
const named: WeakMap<Element, Record<string, string>> = new WeakMap();

/** A text on the page that can change its language. `text`: in English. */
export function spokenText(text: string) {
  const node = document.createTextNode(t(text));
  sources.set(node, text);
  return node;
}

/** An attribute that is read to people. `text`: in English. */
export function name(element: Element, name: string, text: string) {
  const names = named.get(element) ?? {};
  names[name] = text;
  named.set(element, names);
  element.setAttribute(name, t(text));
}

/** Translate what a document holds already, in English; from now on it follows the language. */
export function adopt(root: Element) {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const text = (node.nodeValue ?? "").replace(/\s+/g, " ");
    if (text.trim()) sources.set(node, text);
  }
  for (const element of root.querySelectorAll("[aria-label]")) {
    name(element, "aria-label", element.getAttribute("aria-label") ?? "");
  }
  repeat(root);
}

/** Say again what stands below an element, in the language that is spoken now. */
export function repeat(root: Element) {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const text = sources.get(node);
    if (text !== undefined) node.nodeValue = t(text);
    const names = named.get(node as Element);
    for (const [key, value] of Object.entries(names ?? {})) (node as Element).setAttribute(key, t(value));
  }
}

speak(preferred());
