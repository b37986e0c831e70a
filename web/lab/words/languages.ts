// The choice of a language: in the head of the page, and on the page that makes tags.

import { h } from "../common/dom.ts";
import { current, keep, LANGUAGES, speak } from "./words.ts";

/** `changed`: called when another one is spoken. */
export function languageMenu(changed: () => void) {
  const select = h(
    "select",
    {
      class: "language",
      "aria-label": "Language",
      onchange: () => {
        keep(select.value);
        speak(select.value);
        changed();
      },
    },
    Object.entries(LANGUAGES).map(([code, name]) =>
      h("option", { value: code, lang: code }, document.createTextNode(name)),
    ),
  );
  select.value = current();
  return select;
}
