// Reads requests, one JSON per line, and answers each as the page would. Bundled, it runs as
// `node answer.mjs kernel.js module derivatives < asked > answered`.

import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { LocalBackend } from "../../web/lab/backend/local_backend.ts";
import * as model from "../../web/model/index.ts";
import { numberOf, plain, shortened, written } from "../../web/model/text.ts";
import { spoken } from "../../web/words/texts.ts";

const [script, binary, derivatives] = process.argv.slice(2);
const { HoopModule } = await import(script);
// the modules answer at once what a page has answered by workers
const opened = (name) => new HoopModule(new WebAssembly.Module(readFileSync(name)));
const mechanics = opened(binary);

/** Every bit of doubles, which JSON has not. */
const bits = (doubles) => Buffer.from(doubles.buffer, doubles.byteOffset, doubles.byteLength).toString("hex");

const infinite = (key, value) => (value === Infinity ? "inf" : Number.isNaN(value) ? "nan" : value);

/** @type {Record<string, (body: any) => any>} */
const CALLS = {
  scenario(body) {
    const checked = model.asked(body, mechanics);
    return {
      dict: model.toDict(checked),
      query: model.toQuery(checked),
      toml: model.toToml(checked),
      code: model.pythonCode(checked),
      given: model.given(checked),
    };
  },
  words({ events, status, halfway }) {
    const told = { events, status, omega: (number) => halfway[number] };
    const story = model.story(told).map((sentence) => ({ ...sentence, text: spoken(sentence.text) }));
    return { summary: spoken(model.summary(told)), story };
  },
  thresholds({ scenario, known }) {
    const checked = model.fromDict(scenario, mechanics);
    const infinity = ([name, value]) => [name, value === "inf" ? Infinity : value];
    const rows = model.thresholds(checked, Object.fromEntries(Object.entries(known).map(infinity)));
    return rows.map((row) => ({ ...row, label: spoken(row.label), text: spoken(row.text) }));
  },
  numbers: (values) => values.map((value) =>
      ["{value!r}", "{value:g}", "{value:.3g}", "{value:.2e}", "{value:.1f}"]
        .map((template) => written(template, { value }).value)
        .join(" "),
    ),
  texts: (texts) => texts.map((text) => [plain(text), shortened(text), numberOf(text) ?? null]),
  bounded({ name, body }) {
    const { checked, ...options } = model.requested(body, mechanics);
    if (name === "map") model.withinMap(checked, options);
    else if (name === "film" || name === "samples") model.within(checked);
    return null;
  },
  rates({ scenario, path }) {
    const found = model.ratesOf(model.fromDict(scenario, mechanics), path);
    return found && { ...found, rates: bits(found.rates) };
  },
};

const kernel = Object.assign(Object.create(mechanics), {
  columns: (given, signal, window) => mechanics.columns(given, window),
  changes: (given, rates) => rated().changes(given, rates),
});
let carrying = null;
const rated = () => (carrying ??= opened(derivatives));
const local = new LocalBackend(kernel, mechanics);
CALLS.local = async ({ name, body }) => {
  const { header, arrays } = await local.call(name, body);
  return { header, arrays: Object.fromEntries(Object.entries(arrays).map(([key, array]) => [key, [...array]])) };
};
// a server that does no more than say what it is asked for
const server = {
  call: async (name, body) => ({ header: { name, body }, arrays: {} }),
  file: async (name, query) => new Blob([JSON.stringify({ name, query })]),
};
const served = new LocalBackend(kernel, mechanics, { server });
CALLS.served = async ({ name, body }) => (await served.call(name, body)).header;
CALLS.servedFile = async ({ name, query }) => (await served.file(name, query)).text();
CALLS.changes = async ({ scenario, path }) => {
  const found = await local.changes(scenario, path);
  const side = (one) => one && bits(one.rates);
  return found && { count: found.count, larger: side(found.larger), smaller: side(found.smaller) };
};
CALLS.file = async ({ name, query }) => (await local.file(name, query)).text();

for await (const line of createInterface({ input: process.stdin })) {
  const { call, body } = JSON.parse(line);
  let answer;
  try {
    answer = { value: await CALLS[call](body) };
  } catch (error) {
    if (!(error instanceof model.InputError)) throw error;
    answer = { error: error.message };
  }
  process.stdout.write(`${JSON.stringify(answer, infinite)}\n`);
}
