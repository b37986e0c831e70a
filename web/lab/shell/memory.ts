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

/** What a page remembers until its tab is closed; nothing where storage is forbidden. */
export function recallForTab(key: string) {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}

export function rememberForTab(key: string, value: string) {
  try {
    sessionStorage.setItem(key, value);
  } catch {
    // the page forgets it when it is loaded again
  }
}
