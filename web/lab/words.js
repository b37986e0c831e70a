// Words on the page, which say themselves again in another language. `dom.js` puts every word here; what is drawn on a canvas
// calls `t`.

import { LANGUAGES, spoken } from "../words/texts.js";
import { recall, remember } from "./memory.js";

export { current, LANGUAGES, listed, local, Refused, saidOf, speak, spoken, t, wordsFrom } from "../words/texts.js";

const KEY = "hophoop-language";

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

/** What stands on the page. @type {WeakMap<Node, Said>} */
const sources = new WeakMap();
/** @type {WeakMap<Element, Record<string, Said>>} */
const named = new WeakMap();

/**
 * A text on the page that can change its language.
 * @param {Said} said
 */
export function spokenText(said) {
  const node = document.createTextNode(spoken(said));
  sources.set(node, said);
  return node;
}

/**
 * An attribute that is read to people.
 * @param {Element} element
 * @param {string} name
 * @param {Said} said
 */
export function name(element, name, said) {
  named.set(element, { ...named.get(element), [name]: said });
  element.setAttribute(name, spoken(said));
}

/**
 * Say again what stands below an element, in the language that is spoken now.
 * @param {Element} root
 */
export function repeat(root) {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const said = sources.get(node);
    if (said !== undefined) node.nodeValue = spoken(said);
    const names = named.get(/** @type {Element} */ (node));
    for (const [key, one] of Object.entries(names ?? {})) /** @type {Element} */ (node).setAttribute(key, spoken(one));
  }
}
