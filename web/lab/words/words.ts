// Words on the page, which say themselves again in another language. `dom.ts` puts every word here; what is drawn on a canvas
// calls `t`.

import { LANGUAGES, spoken } from "../../words/texts.ts";
import { recall, remember } from "../shell/memory.ts";

export * from "../../words/texts.ts";

const KEY = "hophoop-language";

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

/** What stands on the page. */
const sources = new WeakMap<Node, Message>();
const named = new WeakMap<Element, Named<Message>>();

/** A text on the page that can change its language. */
export function spokenText(said: Message) {
  const node = document.createTextNode(spoken(said));
  sources.set(node, said);
  return node;
}

/** An attribute that is read to people. */
export function name(element: Element, name: string, said: Message) {
  named.set(element, { ...named.get(element), [name]: said });
  element.setAttribute(name, spoken(said));
}

/** Say again what stands below an element, in the language that is spoken now. */
export function repeat(root: Element) {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const said = sources.get(node);
    if (said !== undefined) node.nodeValue = spoken(said);
    const names = named.get(node as Element);
    for (const [key, one] of Object.entries(names ?? {})) (node as Element).setAttribute(key, spoken(one));
  }
}
