// The page in other languages. English is the source: a word or sentence in English is the key of its translation, and
// numbers and names in it stand as {places}. What Python writes for the page comes in English as well and is recognised
// by the same keys, so that one file a language holds all of it. `dom.js` sends every word that it puts on the page
// through `t`; what is drawn on a canvas or set later calls it.

import TABLES from "../words/tables.js";
import { recall, remember } from "./memory.js";

/** Each language's own name for itself. @param {string} code */
const nameOf = (code) => {
  const name = new Intl.DisplayNames([code], { type: "language" }).of(code) ?? code;
  return name[0].toLocaleUpperCase(code) + name.slice(1);
};

/** Names by code, English first. @type {Record<string, string>} */
export const LANGUAGES = Object.fromEntries(["en", ...Object.keys(TABLES)].map((code) => [code, nameOf(code)]));
const KEY = "hophoop-language";
const MOST = 4000; // sentences that are remembered
const NAMES = /^((\d\S* )?(rad(\/s)?|kg|m\/s²?)|'?[\w.[\]]+\.\w+'?|'\w*'|([\w.]+, )+[\w.]+|hophoop.*)$/u;
const PLACE = /\{(\w+)\}/g;

/** @typedef {{ key: string, pattern: RegExp, names: string[] }} Sentence */

let language = "en";
/** Whether decimals follow a comma. */
let commas = false;
/** @type {Sentence[]} */
let sentences = [];
/** @type {Map<string, string>} */
let known = new Map();
/** What has been said already is not translated again. @type {Set<string>} */
let uttered = new Set();
/** Words that were shown without a translation, for the tests. @type {Set<string>} */
export const untranslated = new Set();

export const current = () => language;

/** @param {string} code one of LANGUAGES */
export function speak(code) {
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

/** @param {string} code */
export function keep(code) {
  remember(KEY, code);
}

/** @param {string} key */
const literal = (key) => key.replace(PLACE, "").length;

/**
 * @param {string} key
 * @returns {Sentence}
 */
function compiled(key) {
  const names = [...key.matchAll(PLACE)].map(([, name]) => name);
  const parts = key.split(/\{\w+\}/).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  return { key, names, pattern: new RegExp(`^${parts.join("(.+?)")}$`, "su") };
}

/**
 * A number as it is written in the language.
 * @param {string} text
 */
export const local = (text) => (commas ? text.replace(/(\d)\.(\d)/g, "$1,$2") : text);

/**
 * A text in the language of the page; what it does not know stays as it is.
 * @param {string} text in English
 * @param {Record<string, string | number>} [values] what stands in its {places}
 * @returns {string}
 */
export function t(text, values) {
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

/**
 * Marks what has been put together from translated pieces.
 * @param {string} text
 */
export function utter(text) {
  if (uttered.size > MOST) uttered.clear();
  uttered.add(text);
  return text;
}

/**
 * A sentence with its values, still in English: what stands on the page so follows the language.
 * @param {string} text
 * @param {Record<string, string | number>} values
 */
export const english = (text, values) => text.replace(PLACE, (_, name) => String(values[name]));

/**
 * Words of the scenario's own, such as 'flight', stay as they are.
 * @param {string} template
 * @param {Record<string, string | number>} values
 */
const filled = (template, values) =>
  template.replace(PLACE, (_, name) => (name.startsWith("word") ? String(values[name]) : t(String(values[name]))));

/**
 * @param {string} text
 * @param {Record<string, string>} table
 */
function recognised(text, table) {
  for (const { key, pattern, names } of sentences) {
    const match = text.match(pattern);
    if (match) return filled(table[key], Object.fromEntries(names.map((name, i) => [name, match[i + 1]])));
  }
  return listed(text);
}

/**
 * Phases in a row, as maps name them.
 * @param {string} text
 */
function listed(text) {
  if (!text.includes(" → ")) return undefined;
  return text
    .split(" → ")
    .map((part) => t(part))
    .join(" → ");
}

/**
 * What Python says of a whole motion, 'Rolls, skids at 49.8°, rolls at 152.7°. It has come to rest.'
 * @param {string} summary
 */
export function told(summary) {
  if (!TABLES[language]) return summary;
  const [, first, rest] = summary.match(/^(.*?)\.(?: (.*))?$/su) ?? ["", summary, ""];
  const { comma, stop } = language === "zh" ? { comma: "，", stop: "。" } : { comma: ", ", stop: "." };
  const phrases = `${first[0]?.toLowerCase() ?? ""}${first.slice(1)}`.split(/, (?!\d)/).map((phrase) => t(phrase));
  const said = phrases.join(comma);
  return utter(`${said[0]?.toLocaleUpperCase(language) ?? ""}${said.slice(1)}${stop}${rest ? ` ${t(rest)}` : ""}`);
}

/** @param {string} text */
function missing(text) {
  // symbols, units, and names of the scenario's keys and of its words are the same everywhere
  const words = /\p{L}{3,}/u.test(text) && !NAMES.test(text);
  if (language !== "en" && words && untranslated.size < 200) untranslated.add(text);
  return local(text);
}

/** What stands on the page in English underneath. @type {WeakMap<Node, string>} */
const sources = new WeakMap();
/** @type {WeakMap<Element, Record<string, string>>} */
const named = new WeakMap();

/**
 * A text on the page that can change its language.
 * @param {string} text in English
 */
export function spokenText(text) {
  const node = document.createTextNode(t(text));
  sources.set(node, text);
  return node;
}

/**
 * An attribute that is read to people.
 * @param {Element} element
 * @param {string} name
 * @param {string} text in English
 */
export function name(element, name, text) {
  const names = named.get(element) ?? {};
  names[name] = text;
  named.set(element, names);
  element.setAttribute(name, t(text));
}

/**
 * Translate what a document holds already, in English; from now on it follows the language.
 * @param {Element} root
 */
export function adopt(root) {
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

/**
 * Say again what stands below an element, in the language that is spoken now.
 * @param {Element} root
 */
export function repeat(root) {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const text = sources.get(node);
    if (text !== undefined) node.nodeValue = t(text);
    const names = named.get(/** @type {Element} */ (node));
    for (const [key, value] of Object.entries(names ?? {})) /** @type {Element} */ (node).setAttribute(key, t(value));
  }
}

speak(preferred());
