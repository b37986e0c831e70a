// Reads requests, one JSON per line, and answers each as the page would. Bundled, it runs as
// `node answer.mjs kernel.js module < asked > answered`.

import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { Backend } from "../../web/lab/backend/backend.ts";
import { classColor } from "../../web/model/cells.ts";
import * as model from "../../web/model/index.ts";
import { numberOf, plain, shortened, written } from "../../web/model/text.ts";
import { spoken } from "../../web/words/texts.ts";

const [script, binary] = process.argv.slice(2);
const { HoopModule } = await import(script);
// the module answers at once what a page has answered by workers
const mechanics = new HoopModule(new WebAssembly.Module(readFileSync(binary)));

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
  numbers: (values) =>
    values.map((value) =>
      ["{value!r}", "{value:g}", "{value:.3g}", "{value:.2e}", "{value:.1f}"]
        .map((template) => written(template, { value }).value)
        .join(" "),
    ),
  colors: (classes) => classes.map(([name, quantity]) => classColor(name, quantity)),
  texts: (texts) => texts.map((text) => [plain(text), shortened(text), numberOf(text) ?? null]),
};

const kernel = { ask: (call, values) => mechanics[call](...values) };
const local = new Backend(kernel, mechanics);
const listed = (arrays) => Object.fromEntries(Object.entries(arrays).map(([key, array]) => [key, [...array]]));
const packed = ({ header, arrays }) => ({ header, arrays: listed(arrays) });
CALLS.film = async (body) => packed(await local.film(body, undefined, body.bounded));
CALLS.map = async (body) => packed(await local.map(body));
CALLS.samples = async ({ scenario, window }) => listed(await local.samples(scenario, window));
CALLS.theory = ({ scenario }) => local.theory(scenario);
CALLS.changes = async ({ scenario, path, value, step }) => {
  const { events } = (await local.film({ scenario })).header;
  return local.changes({ scenario, events }, path, value, step);
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
