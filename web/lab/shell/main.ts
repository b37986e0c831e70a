// Two ways in: the page of the lab, and the notebook widget. One source for both.

import { tables } from "../../model/index.ts";
import { queries, readShown, type Address } from "./address.ts";
import { say } from "../common/dom.ts";
import { Lab } from "./lab.ts";
import { NotebookKernel, type Model } from "../backend/python.ts";
import { backendOf, keepOffline, widgetBackend } from "../backend/start.ts";
import { preferred, messageOf, speak, wordsFrom } from "../words/words.ts";

/** The folder of the script; a notebook has none. */
const here = () => new URL("./", import.meta.url);

/** The visitor's language, from the files beside the script; English where it is not to be had. */
function speakFrom(folder: URL) {
  wordsFrom(async (code) => {
    const response = await fetch(new URL(`words.${code}.json?${WORDS}`, folder));
    if (!response.ok) throw new Error(`words.${code}.json: ${response.status}`);
    return response.json();
  });
  return speak(preferred()).catch(() => {});
}

/** Of a notebook, with which the words of all languages travel. */
function speakPacked(packed: DataView<ArrayBuffer>) {
  const unpacked = async () => {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).json();
  };
  let tables: Promise<Record<string, Words>> | undefined;
  wordsFrom(async (code) => {
    tables ??= unpacked();
    return (await tables)[code];
  });
  return speak(preferred()).catch(() => {});
}

/** What does not start is said in its place, once the words are there; returns null then. */
async function started<T>(root: HTMLElement, words: Promise<void>, starting: Promise<T>) {
  let failed: Error | null = null;
  const found = await starting.catch((error) => {
    failed = error;
    return null;
  });
  await words;
  if (failed) say(root, messageOf(failed));
  return found;
}

async function startPage(root: HTMLElement) {
  const base = new URL("./", document.baseURI.split(/[?#]/)[0]);
  const site = document.querySelector("meta[name=hophoop-site]");
  const backend = await started(root, speakFrom(here()), backendOf(here(), site ? null : base, base));
  if (!backend) return;
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

/**
 * A live hoop in any page, for <hophoop-motion>; null where it cannot start, which is said in its place. `folder`: of
 * the script and the module.
 */
export async function mount(root: HTMLElement, folder: URL, query: string, panels: string[]) {
  const backend = await started(root, speakFrom(folder), backendOf(folder, null, new URL("../", folder)));
  if (!backend) return null;
  const lab = new Lab(root, backend, tables.setup, { panels });
  try {
    await lab.open([query]);
    return lab;
  } catch (error) {
    lab.close();
    say(root, messageOf(error));
    return null;
  }
}

/**
 * anywidget: the module travels with the notebook, so that it plays without a kernel as well. `worker`: address of its
 * script.
 */
async function render({ model, el }: { model: Model; el: HTMLElement }, worker: string) {
  const root = document.createElement("div");
  el.append(root);
  const python = new NotebookKernel(model);
  const words = speakPacked(model.get("words"));
  const backend = await started(root, words, widgetBackend(model, python, worker));
  // the motion that Python shows, however long
  const given = () => (backend as Backend).film({ query: model.get("given") }, undefined, false);
  const first = backend && (await started(root, words, given()));
  if (!backend || !first) return () => python.close();
  const lab = new Lab(root, backend, tables.setup, {
    panels: model.get("panels"),
    // the kernel has computed this motion already; what depends on it may follow now
    onmotion: (query) => {
      if (model.get("query") === query) return;
      model.set("query", query);
      model.save_changes();
    },
  });
  lab.motions.set([first]);
  lab.begin();
  const replaced = () => lab.motions.inTurn(async () => lab.motions.replace(await given()));
  model.on("change:given", replaced);
  return () => {
    model.off("change:given", replaced);
    python.close();
    lab.close();
  };
}

const page = document.getElementById("hophoop-lab");
if (page) startPage(page);

export default { render };

// for the page that makes tags
export { say } from "../common/dom.ts";
export { languageMenu } from "../words/languages.ts";
export { current, name, repeat, t } from "../words/words.ts";
export { speakFrom };
