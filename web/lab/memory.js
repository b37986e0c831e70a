// What the page remembers of a visitor, in the visitor's own browser. Storage may be forbidden; then it lasts as long as the page.

/** @type {Map<string, string>} */
const held = new Map();

/** @param {string} key */
export function recall(key) {
  try {
    return localStorage.getItem(key) ?? held.get(key) ?? null;
  } catch {
    return held.get(key) ?? null;
  }
}

/**
 * @param {string} key
 * @param {string} value
 */
export function remember(key, value) {
  held.set(key, value);
  try {
    localStorage.setItem(key, value);
  } catch {
    // it stays in `held`
  }
}
