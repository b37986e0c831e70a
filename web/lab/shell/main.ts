// Four ways in: the page of the lab, from a folder or as one file, a hoop in another page, and a notebook's widget.

import { WorkerKernel } from "../../kernel/kernel.ts";
import { unpacked, type Packed } from "../../kernel/packed.ts";
import { tables } from "../../model/tables.ts";
import { queries, readShown, shownIn, type Address } from "./address.ts";
import { say } from "../common/dom.ts";
import { Lab } from "./lab.ts";
import { preferred, messageOf, speak, wordsFrom } from "../words/words.ts";
import { Backend } from "../backend/backend.ts";

/** The folder of the script, where it lies in one. */
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

/** Of a notebook or a file, with which the words of all languages travel. */
function speakPacked(packed: Packed) {
  let tables: Promise<Named<Words>> | undefined;
  wordsFrom(async (code) => {
    tables ??= unpacked(packed).json();
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

/** What the page is told at its head, by name. */
const told = (name: string) => document.querySelector<HTMLMetaElement>(`meta[name=hophoop-${name}]`)?.content;

/** The address of the page without what it shows. */
const ownAddress = () => document.baseURI.split(/[?#]/)[0];

/** From a folder, whose files lie beside the script. */
async function startPage(root: HTMLElement) {
  const base = new URL("./", ownAddress()).href;
  const backend = await started(root, speakFrom(here()), backendOf(WorkerKernel.load(here()), base));
  const site = told("site");
  if (backend && site) keepOffline(site);
  await open(root, backend, base);
}

/** From what the page itself holds, compressed, by name. `worker`: address of the worker's script. */
async function startFile(root: HTMLElement, held: (name: string) => Packed, worker: string) {
  const kernel = WorkerKernel.unpack(held("module"), worker, async () => held("fates"));
  const base = told("url") ?? ownAddress();
  await open(root, await started(root, speakPacked(held("words")), backendOf(kernel, base)), "");
}

/** `own`: what the address of the page begins with. */
async function open(root: HTMLElement, backend: Backend | null, own: string) {
  if (!backend) return;
  const lab = new Lab(root, backend, tables.setup, { own });
  Object.assign(globalThis, { hophoopLab: lab });
  const shown = readShown(shownIn(location).view);
  const address = lab.address as Address;
  const { links, said } = address.read(queries());
  try {
    await lab.open(links, shown);
    said();
  } catch (error) {
    // a link that holds no scenario: say so, and show the reference case
    address.held = true;
    await lab.open([""]);
    lab.notice.fail(error);
  }
}

/**
 * A live hoop in any page, for <hophoop-motion>; null where it cannot start, which is said in its place. `folder`: of
 * the script and the module.
 */
export async function mount(root: HTMLElement, folder: URL, query: string, panels: string[]) {
  const kernel = WorkerKernel.load(folder);
  const backend = await started(root, speakFrom(folder), backendOf(kernel, new URL("../", folder).href));
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
  const words = speakPacked(model.get("words"));
  const python = new NotebookKernel(model);
  const kernel = WorkerKernel.unpack(model.get("module"), worker, () => python.fates());
  const backend = await started(root, words, backendOf(kernel, null));
  // the motion that Python shows, however long
  const given = () => (backend as Backend).film({ query: model.get("given") }, undefined, false);
  const first = backend && (await started(root, words, given()));
  if (!backend || !first) return () => {};
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
    lab.close();
  };
}

const page = document.getElementById("hophoop-lab");
if (page) startPage(page);

export default { open: startFile, render };

// for the page that makes tags
export { say } from "../common/dom.ts";
export { languageMenu } from "./extras.ts";
export { current, name, repeat, t } from "../words/words.ts";
export { speakFrom };

// --- What a page answers with, once the kernel that it computes with is there

/** `base`: what links begin with, where there are any to share. */
async function backendOf(loading: Promise<WorkerKernel>, base: string | null) {
  const kernel = await loading.catch((error) => {
    throw typeof WebAssembly === "object" && !(error instanceof WebAssembly.CompileError) ? error : unable(error);
  });
  return new Backend(kernel, kernel.mechanics, base);
}

/** Whether it is the page around that does not allow it, or the browser that cannot. */
const unable = ({ message }: Error) =>
  new Error(/content security|\bcsp\b/i.test(message) ? "page.wasm_forbidden" : "page.wasm_missing");

// The page without a network: the browser keeps its files once they have been there.
function keepOffline(script: string) {
  // a page that is opened from a disk, or embedded, does without
  navigator.serviceWorker
    ?.register(script)
    .then((found) => found.update())
    .catch(() => {});
}

// --- The module of fates, which a notebook's kernel sends when it is asked for: it is larger than most notebooks

const PATIENCE = 20_000; // milliseconds

/** The part of an anywidget model that is used. */
type Model = {
  get(name: string): any;
  set(name: string, value: unknown): void;
  save_changes(): void;
  send(message: object): void;
  on(name: string, listener: (...values: any[]) => void): void;
  off(name: string, listener: (...values: any[]) => void): void;
};

class NotebookKernel {
  constructor(readonly model: Model) {}

  /** Several views of one widget share its messages; each answers to its own. */
  fates(): Promise<DataView<ArrayBuffer>> {
    const { model } = this;
    const number = Math.random();
    return new Promise((resolve, reject) => {
      const end = () => {
        clearTimeout(timer);
        model.off("msg:custom", answered);
      };
      const answered = (message: any, buffers: DataView<ArrayBuffer>[]) => {
        if (message?.number !== number) return;
        end();
        resolve(buffers[0]);
      };
      // a saved notebook plays without a kernel
      const timer = setTimeout(() => {
        end();
        reject(new Error("backend.notebook_silent"));
      }, PATIENCE);
      model.on("msg:custom", answered);
      model.send({ number });
    });
  }
}
