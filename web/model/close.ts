// The key that somebody may have meant: Python's difflib.get_close_matches with one answer.

const LEAST = 0.6;

/** How many signs two texts have in common, in longest pieces: difflib's matching blocks. */
function common(a: string[], b: string[]): number {
  let [size, first, second] = [0, 0, 0];
  // the longest piece, of several the first in a and then in b
  for (let i = 0; i < a.length; i++) {
    for (let j = 0; j < b.length; j++) {
      let k = 0;
      while (i + k < a.length && j + k < b.length && a[i + k] === b[j + k]) k++;
      if (k > size) [size, first, second] = [k, i, j];
    }
  }
  if (!size) return 0;
  return size + common(a.slice(0, first), b.slice(0, second)) + common(a.slice(first + size), b.slice(second + size));
}

export function closest(word: string, known: string[]): string | undefined {
  const asked = [...word];
  let best: string | undefined;
  let most = 0;
  for (const name of known) {
    const signs = [...name];
    const length = signs.length + asked.length;
    // no more can be in common than the shorter has
    if ((2 * Math.min(signs.length, asked.length)) / length < LEAST) continue;
    const ratio = (2 * common(signs, asked)) / length;
    if (ratio >= LEAST && (ratio > most || (ratio === most && best !== undefined && name > best))) {
      [best, most] = [name, ratio];
    }
  }
  return best;
}
