// What the page remembers of a visitor, in the visitor's own browser. Storage may be forbidden; then it lasts as long as the page.

const held = new Map<string, string>();

type Storing = "localStorage" | "sessionStorage"; // for ever, or until the tab is closed

export function recall(key: string, where: Storing = "localStorage") {
  try {
    return globalThis[where].getItem(key) ?? held.get(key) ?? null;
  } catch {
    return held.get(key) ?? null;
  }
}

export function remember(key: string, value: string, where: Storing = "localStorage") {
  held.set(key, value);
  try {
    globalThis[where].setItem(key, value);
  } catch {
    // it stays in `held`
  }
}
