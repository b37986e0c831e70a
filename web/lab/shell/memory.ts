// What the page remembers of a visitor, in the visitor's own browser. Storage may be forbidden; then it lasts as long as the page.

const held: Map<string, string> = new Map();

export function recall(key: string) {
  try {
    return localStorage.getItem(key) ?? held.get(key) ?? null;
  } catch {
    return held.get(key) ?? null;
  }
}

export function remember(key: string, value: string) {
  held.set(key, value);
  try {
    localStorage.setItem(key, value);
  } catch {
    // it stays in `held`
  }
}
