// Small pictures for the buttons of the player; no font needs to have them.

const ICONS = {
  play: "M5 3l9 5.5L5 14z",
  pause: "M4 3h3.4v11H4zM9.6 3H13v11H9.6z",
  start: "M3 3h2v11H3zM14 3v11L6 8.5z",
  back: "M11.5 3.5v10L4.5 8.5z",
  on: "M5.5 3.5v10l7-5z",
  previous: "M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",
  next: "M2 3.5v10l6-5zM8.5 3.5v10l6-5z",
  undo: "M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",
  redo: "M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",
  two: "M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",
  theme: "M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z",
};

/** @param {keyof typeof ICONS} name */
export function icon(name) {
  const space = "http://www.w3.org/2000/svg";
  const picture = document.createElementNS(space, "svg");
  picture.setAttribute("viewBox", "0 0 17 17");
  picture.setAttribute("aria-hidden", "true");
  picture.setAttribute("class", "icon");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", ICONS[name]);
  picture.append(path);
  return picture;
}
