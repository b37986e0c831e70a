// A notebook's widget: the page's scripts travel with the motion.

import { addressesOf } from "../kernel/packed.ts";

let addressOf: ReturnType<typeof addressesOf> | null = null;

async function render(given: { model: { get: (name: "scripts") => Named<string> } }) {
  addressOf ??= addressesOf(given.model.get("scripts"));
  const { default: lab } = await import(addressOf("lab.js"));
  return lab.render(given, addressOf("worker.js"));
}

export default { render };
