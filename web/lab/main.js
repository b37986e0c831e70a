// Two ways in: the page of the lab, and the notebook widget. One source for both.

import { queries, readShown } from "./address.js";
import { Lab } from "./lab.js";
import { unpack } from "./packing.js";
import { backendOf, keepOffline, widgetBackend } from "./start.js";

const here = new URL("./", import.meta.url);

/** @param {HTMLElement} root */
async function startPage(root) {
  const base = new URL("./", document.baseURI.split(/[?#]/)[0]);
  const site = document.querySelector("meta[name=hophoop-site]");
  let backend;
  let setup;
  try {
    backend = await backendOf(here, site ? null : base, base);
    setup = (await backend.call("setup", {})).header;
  } catch (error) {
    root.textContent = /** @type {Error} */ (error).message;
    return;
  }
  if (site) keepOffline(site.getAttribute("content") ?? "");
  const lab = new Lab(root, backend, setup, { hosted: true });
  Object.assign(globalThis, { hophoopLab: lab });
  const shown = readShown(location.hash);
  const address = /** @type {import("./address.js").Address} */ (lab.address);
  const { links, said } = address.read(queries());
  try {
    await lab.open(links, shown);
    said();
  } catch (error) {
    // a link that holds no scenario: say so, and show the reference case
    address.held = true;
    await lab.open([""]);
    lab.notice.fail(/** @type {Error} */ (error));
  }
}

/**
 * A live hoop in any page, for <hophoop-motion>.
 * @param {HTMLElement} root
 * @param {URL} folder of the script and the module
 * @param {string} query
 * @param {string[]} panels
 */
export async function mount(root, folder, query, panels) {
  const backend = await backendOf(folder, null, new URL("../", folder));
  const { header } = await backend.call("setup", {});
  const lab = new Lab(root, backend, header, { panels });
  await lab.open([query]);
  return lab;
}

/**
 * anywidget: the motion travels with the notebook, so that it plays without a kernel as well.
 * @param {{ model: import("./backend.js").Model, el: HTMLElement }} widget
 */
async function render({ model, el }) {
  const root = document.createElement("div");
  el.append(root);
  const backend = await widgetBackend(model);
  const lab = new Lab(root, backend, model.get("setup"), {
    panels: model.get("panels"),
    // the kernel has computed this motion already; what depends on it may follow now
    onmotion: (query) => {
      if (model.get("query") === query) return;
      model.set("query", query);
      model.save_changes();
    },
  });
  lab.motions.set([unpack(model.get("film"))]);
  lab.begin();
  const replaced = () => lab.motions.replace(unpack(model.get("film")));
  model.on("change:film", replaced);
  return () => {
    model.off("change:film", replaced);
    backend.close?.();
    lab.close();
  };
}

const page = document.getElementById("hophoop-lab");
if (page) startPage(page);

export default { render };

// for the page that makes tags
export { languageMenu } from "./languages.js";
export { adopt, current, repeat, t, untranslated } from "./words.js";
