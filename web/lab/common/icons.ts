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
  reset: "M8.5 3V.8L4.4 4l4.1 3.2V5a4.3 4.3 0 1 1-4.3 4.3H2.2A6.3 6.3 0 1 0 8.5 3z",
  two: "M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",
  loop: "M4 4h7.5V1.8L15.5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",
  slow: "M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",
  sound: "M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",
  large: "M2 2h5v2H4v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",
  share: "M8.5 1l4 4h-3v6h-2V5h-3zM2.5 8h2v5.5h8V8h2v7.5h-12z",
  theme: "M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z",
};

export function icon(name: keyof typeof ICONS) {
  const space = "http://www.w3.org/2000/svg";
  const picture = document.createElementNS(space, "svg");
  picture.setAttribute("viewBox", "0 0 17 17");
  picture.setAttribute("aria-hidden", "true");
  picture.setAttribute("class", `icon icon-${name}`);
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", ICONS[name]);
  picture.append(path);
  return picture;
}
