// Texts by key and values, in the language that is spoken. English travels with the page, another language comes when it is
// chosen. A language is its table in src/hophoop/lab/words and its code in `CODES`.

import en from "../../src/hophoop/lab/words/en.json" with { type: "json" };

const CODES = ["en", "de", "es", "fr", "zh"];
const PLACE = /\{(\w+)\}/g;

/** Each language's own name for itself. */
const nameOf = (code: string) => {
  const name = new Intl.DisplayNames([code], { type: "language" }).of(code) ?? code;
  return name[0].toLocaleUpperCase(code) + name.slice(1);
};

/** Names by code. */
export const LANGUAGES: Named<string> = Object.fromEntries(CODES.map((code) => [code, nameOf(code)]));

/** Without a prototype: whatever somebody writes into a link may be looked up. */
const bare = (words: Words): Words => Object.assign(Object.create(null), words);
const ENGLISH = bare(en);
/** Tables by code, and where another comes from. */
const tables = new Map<string, Words>([["en", ENGLISH]]);
let source: (code: string) => Promise<Words> = async () => ENGLISH;

let language = "en";
let table = ENGLISH;
let plurals = new Intl.PluralRules("en");
/** Whether decimals follow a comma. */
let commas = false;

export const current = () => language;

/** `from`: gives the table of a language. */
export function wordsFrom(from: (code: string) => Promise<Words>) {
  source = from;
}

/** Speak a language from now on; what is shown already follows by `repeat`. `code`: one of LANGUAGES. */
export async function speak(code: string) {
  const found = tables.get(code) ?? bare(await source(code));
  tables.set(code, found);
  [language, table] = [code, found];
  plurals = new Intl.PluralRules(code);
  commas = (1.5).toLocaleString(code).includes(",");
}

/** A number as it is written in the language. */
export const local = (text: string) => (commas ? text.replace(/(\d)\.(\d)/g, "$1,$2") : text);

/**
 * A text in the language of the page. What is no key, such as a name, a symbol or a number, stays as it is. `values`:
 * of its {places}; a place with a capital begins with one; `count` chooses the plural.
 */
export function t(key: string, values?: Values): string {
  const found = table[key] ?? ENGLISH[key];
  if (found === undefined) return local(key);
  const text = typeof found === "string" ? found : (found[plurals.select(Number(values?.count))] ?? found.other);
  return values ? text.replace(PLACE, (_, name) => placed(name, values)) : text;
}

function placed(name: string, values: Values) {
  if (name in values) return spoken(values[name]);
  const text = spoken(values[name[0].toLowerCase() + name.slice(1)]);
  return text.slice(0, 1).toLocaleUpperCase(language) + text.slice(1);
}

/**
 * What is said, as a text: that of a key, with its values, of all parts of a list, or of what puts it together
 * itself.
 */
export function spoken(said: Message): string {
  if (typeof said === "string") return t(said);
  if (typeof said === "number") return local(String(said));
  if (typeof said === "function") return said();
  return Array.isArray(said) ? said.map(spoken).join("") : t(said.key, said.values);
}

/** Several things in a row. */
export const listed = (parts: Message[]): Message[] => parts.flatMap((part, k) => (k ? ["list.comma", part] : [part]));

/** In English, for what is written down and for those who look in from outside. */
export function english(phrase: Phrase) {
  const before = { language, table, plurals, commas };
  [language, table, plurals, commas] = ["en", ENGLISH, new Intl.PluralRules("en"), false];
  try {
    return spoken(phrase);
  } finally {
    ({ language, table, plurals, commas } = before);
  }
}

/** An error that is said in the language of the page; its message is English. */
export class Refused extends Error {
  constructor(public said: Phrase) {
    super(english(said));
  }
}

/** What there is to say of an error: its key, its phrase, or a message from elsewhere. */
export const messageOf = (error: any): Message => error.said ?? error.message;
