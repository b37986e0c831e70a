// What travels in a notebook or in a page that is one file: words and modules compressed by gzip, scripts as texts.

export type Packed = ArrayBufferView<ArrayBuffer>;

/** The content, as a response that reads it as JSON or bytes. */
export function unpacked(packed: Packed) {
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")));
}

/** Gives scripts their addresses, at which they find each other. */
export function addressesOf(scripts: Named<string>) {
  const addresses: Named<string> = {};
  const addressOf = (name: string): string => {
    addresses[name] ??= URL.createObjectURL(new Blob([linked(scripts[name])], { type: "text/javascript" }));
    return addresses[name];
  };
  const linked = (text: string) => text.replace(/"\.\/([\w-]+\.js)"/g, (_, name) => JSON.stringify(addressOf(name)));
  return addressOf;
}
