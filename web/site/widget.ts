// A notebook's widget: the page's scripts travel with the motion, and find each other at the addresses that they get here.

type Scripts = Record<string, string>;

function addressesOf(scripts: Scripts) {
  const addresses: Record<string, string> = {};
  const addressOf = (name: string): string => {
    addresses[name] ??= URL.createObjectURL(new Blob([linked(scripts[name])], { type: "text/javascript" }));
    return addresses[name];
  };
  const linked = (text: string) => text.replace(/"\.\/([\w-]+\.js)"/g, (_, name) => JSON.stringify(addressOf(name)));
  return addressOf;
}

let addressOf: ReturnType<typeof addressesOf> | null = null;

async function render(given: { model: { get: (name: "scripts") => Scripts } }) {
  addressOf ??= addressesOf(given.model.get("scripts"));
  const { default: lab } = await import(addressOf("lab.js"));
  return lab.render(given, addressOf("kernel.js"));
}

export default { render };
