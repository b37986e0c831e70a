// Sequences of modes, unpacked from the numbers into which the kernel packs them.

import { layout } from "./layout.ts";

export function sequencesOf(keys: BigUint64Array, count: number): MapValues {
  const codes: Map<string, number> = new Map();
  const values = new Float64Array(count);
  for (let k = 0; k < count; k++) {
    const word = unpacked(keys.subarray(k * layout.keys, (k + 1) * layout.keys));
    if (word === "") {
      values[k] = Number.NaN; // not allowed
      continue;
    }
    let code = codes.get(word);
    if (code === undefined) {
      code = codes.size;
      codes.set(word, code);
    }
    values[k] = code;
  }
  return { values, sequences: [...codes.keys()] };
}

function unpacked(keys: BigUint64Array) {
  let word = "";
  for (const key of keys) {
    let rest = key;
    for (let place = 0; place < layout.letters_a_key && rest; place++) {
      const letter = Number(rest & 7n);
      rest >>= 3n;
      if (letter) word += letter === layout.more ? "+" : layout.letters[letter - 1];
    }
  }
  return word;
}
