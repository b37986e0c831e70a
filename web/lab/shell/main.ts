// Two ways in: the page of the lab, and the notebook widget. One source for both.

import { tables } from "../../model/index.ts";
import { queries, readShown, type Address } from "./address.ts";
import { say } from "../common/dom.ts";
import { Lab } from "./lab.ts";
import { unpack } from "../backend/packing.ts";
import { NotebookKernel, type Model } from "../backend/python.ts";
import { backendOf, keepOffline, widgetBackend } from "../backend/start.ts";

const here = new URL("./", import.meta.url);

async function startPage(root: HTMLElement) {
  const base = new URL("./", document.baseURI.split(/[?#]/)[0]);
  const site = document.querySelector("meta[name=hophoop-site]");
  let backend: Backend;
  try {
    backend = await backendOf(here, site ? null : base, base);
  } catch (error) {
    say(root, (error as Error).message);
    return;
  }
  if (site) keepOffline(site.getAttribute("content") ?? "");
  const lab = new Lab(root, backend, tables.setup, { hosted: true });
  Object.assign(globalThis, { hophoopLab: lab });
  const shown = readShown(location.hash);
  const address = lab.address as Address;
  const { links, said } = address.read(queries());
  try {
    await lab.open(links, shown);
    said();
  } catch (error) {
    // a link that holds no scenario: say so, and show the reference case
    address.held = true;
    await lab.open([""]);
    lab.notice.fail(error as Error);
  }
}

/** A live hoop in any page, for <hophoop-motion>. `folder`: of the script and the module. */
export async function mount(root: HTMLElement, folder: URL, query: string, panels: string[]) {
  const backend = await backendOf(folder, null, new URL("../", folder));
  const lab = new Lab(root, backend, tables.setup, { panels });
  await lab.open([query]);
  return lab;
}

/** anywidget: the motion travels with the notebook, so that it plays without a kernel as well. */
async function render({ model, el }: { model: Model; el: HTMLElement }) {
  const root = document.createElement("div");
  el.append(root);
  const python = new NotebookKernel(model);
  let backend: Backend;
  try {
    backend = await widgetBackend(model, python);
  } catch (error) {
    say(root, (error as Error).message);
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
export { languageMenu } from "../words/languages.ts";
export { adopt, current, repeat, t, untranslated } from "../words/words.ts";
