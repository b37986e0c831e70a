// The choice of a language: in the head of the page, and on the page that makes tags.

import { h } from "../common/dom.ts";
import { current, keep, LANGUAGES, speak } from "./words.ts";

/** `changed`: called when another one is spoken; `failed`: where it is not to be had. */
export function languageMenu(changed: () => void, failed: (error: Error) => void = () => {}) {
  const select = h(
    "select",
    {
      class: "language",
      "aria-label": "language.language",
      onchange: async () => {
        try {
          await speak(select.value);
          keep(select.value);
          changed();
        } catch {
          select.value = current();
          failed(new Error("language.not_loaded"));
        }
      },
    },
    Object.entries(LANGUAGES).map(([code, name]) =>
      h("option", { value: code, lang: code }, document.createTextNode(name)),
    ),
  );
  select.value = current();
  return select;
}
