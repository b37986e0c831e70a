// Two ways in: the page of the lab, and the notebook widget. One source for both.

import { tables } from "../model/index.js";
import { readShown } from "./address.js";
import { say } from "./dom.js";
import { Lab } from "./lab.js";
import { unpack } from "./packing.js";
import { NotebookKernel } from "./python.js";
import { backendOf, keepOffline, widgetBackend } from "./start.js";

const here = new URL("./", import.meta.url);

/** @param {HTMLElement} root */
async function startPage(root) {
  const base = new URL("./", document.baseURI.split(/[?#]/)[0]);
  const site = document.querySelector("meta[name=hophoop-site]");
  let backend;
  try {
    backend = await backendOf(here, site ? null : base, base);
  } catch (error) {
    say(root, /** @type {Error} */ (error).message);
    return;
  }
  if (site) keepOffline(site.getAttribute("content") ?? "");
  const lab = new Lab(root, backend, tables.setup, { hosted: true });
  Object.assign(globalThis, { hophoopLab: lab });
  const other = new URLSearchParams(location.hash.slice(1)).get("with");
  const shown = readShown(location.hash);
  try {
    await lab.open([location.search.slice(1), ...(other === null ? [] : [other])], shown);
  } catch (error) {
    // a link that holds no scenario: say so, and show the reference case
    history.replaceState(null, "", base);
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
  const lab = new Lab(root, backend, tables.setup, { panels });
  await lab.open([query]);
  return lab;
}

/**
 * anywidget: the motion travels with the notebook, so that it plays without a kernel as well.
 * @param {{ model: import("./python.js").Model, el: HTMLElement }} widget
 */
async function render({ model, el }) {
  const root = document.createElement("div");
  el.append(root);
  const python = new NotebookKernel(model);
  let backend;
  try {
    backend = await widgetBackend(model, python);
  } catch (error) {
    say(root, /** @type {Error} */ (error).message);
    return () => python.close();
  }
  const shown = () => backend.shown(unpack(model.get("film")));
  const lab = new Lab(root, backend, tables.setup, {
    panels: model.get("panels"),
    // the kernel has computed this motion already; what depends on it may follow now
    onmotion: (query) => {
      if (model.get("query") === query) return;
      model.set("query", query);
      model.save_changes();
    },
  });
  lab.motions.set([shown()]);
  lab.begin();
  const replaced = () => lab.motions.replace(shown());
  model.on("change:film", replaced);
  return () => {
    model.off("change:film", replaced);
    python.close();
    lab.close();
  };
}

const page = document.getElementById("hophoop-lab");
if (page) startPage(page);

export default { render };

// for the page that makes tags
export { languageMenu } from "./languages.js";
export { adopt, current, repeat, t, untranslated } from "./words.js";
