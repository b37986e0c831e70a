// What a page answers with: the kernel that it computes with, and Python beside it where there is one.

import { WorkerKernel } from "../kernel/kernel.js";
import { Backend } from "./backend.js";
import { Server } from "./python.js";

/**
 * @param {Promise<WorkerKernel>} loading
 * @param {{ base?: URL, python?: Python | null }} beside
 */
async function backend(loading, beside) {
  const kernel = await loading.catch((error) => {
    const able = typeof WebAssembly === "object" && !(error instanceof WebAssembly.CompileError);
    throw able ? error : new Error("This needs a browser that runs WebAssembly.");
  });
  return new Backend(kernel, kernel.mechanics, beside);
}

/**
 * @param {URL} folder of the script, with the module beside it
 * @param {URL | null} server address of the page's server
 * @param {URL} base what links begin with
 */
export function backendOf(folder, server, base) {
  return backend(WorkerKernel.load(folder), { base, python: server && new Server(server) });
}

/**
 * Of a notebook: the module has come with it.
 * @param {import("./python.js").Model} model
 * @param {import("./python.js").NotebookKernel} python
 */
export function widgetBackend(model, python) {
  const kernel = WorkerKernel.unpack(model.get("module"), model.get("worker"), () => python.derivatives());
  return backend(kernel, { python });
}

// The page without a network: the browser keeps its files once they have been there.
/** @param {string} script */
export function keepOffline(script) {
  // a page that is opened from a disk, or embedded, does without
  navigator.serviceWorker?.register(script).catch(() => {});
}
