// Two ways in: the page of the lab, and the notebook widget. One source for both.

import { Lab } from "./app.js";
import { HttpBackend, KernelBackend } from "./backend.js";
import { unpack } from "./frames.js";

async function startPage(root) {
  const base = new URL("./", document.baseURI.split(/[?#]/)[0]);
  const lab = new Lab(root, new HttpBackend(base), { hosted: true });
  const other = new URLSearchParams(location.hash.slice(1)).get("with");
  const queries = [location.search.slice(1), ...(other === null ? [] : [other])];
  globalThis.hophoopLab = lab;
  try {
    await lab.start({ queries });
  } catch (error) {
    if (!lab.setup) {
      root.textContent = error.message;
      return;
    }
    // a link that holds no scenario: say so, and show the reference case
    lab.lanes = [];
    history.replaceState(null, "", base);
    await lab.start({ setup: lab.setup, queries: [""] });
    lab.fail(error);
  }
}

// anywidget: the motion travels with the notebook, so that it plays without a kernel as well.
function render({ model, el }) {
  const root = document.createElement("div");
  el.append(root);
  const backend = new KernelBackend(model);
  const lab = new Lab(root, backend, { panels: model.get("panels") });
  // the kernel has computed this motion already; what depends on it may follow now
  lab.onmotion = (query) => {
    if (model.get("query") === query) return;
    model.set("query", query);
    model.save_changes();
  };
  lab.start({ setup: model.get("setup"), films: [unpack(model.get("film"))] });
  const replaced = () => lab.replace(unpack(model.get("film")));
  model.on("change:film", replaced);
  return () => {
    model.off("change:film", replaced);
    backend.close();
    lab.close();
  };
}

const page = document.getElementById("hophoop-lab");
if (page) startPage(page);

export default { render };
