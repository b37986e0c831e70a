// Where a page's answers come from: its own kernel where the browser can run it, else the server of the page, if it has one.

import { WorkerKernel } from "../kernel/kernel.js";
import { HttpBackend, KernelBackend } from "./backend.js";
import { LocalBackend } from "./local_backend.js";

/**
 * @param {URL} folder of the script, with the module beside it
 * @param {URL | null} server address of the page's server
 * @param {URL} page what links begin with
 * @returns {Promise<Backend>}
 */
export async function backendOf(folder, server, page) {
  const remote = server && new HttpBackend(server);
  try {
    const kernel = await WorkerKernel.load(folder);
    return new LocalBackend(kernel, kernel.mechanics, { base: page, server: remote });
  } catch (error) {
    if (remote) return remote;
    throw error;
  }
}

// The page without a network: the browser keeps its files once they have been there.
/** @param {string} script */
export function keepOffline(script) {
  // a page that is opened from a disk, or embedded, does without
  navigator.serviceWorker?.register(script).catch(() => {});
}

/**
 * Of a notebook: its page computes by itself; what needs Python, and what the page may not do, its kernel does.
 * @param {import("./backend.js").Model} model
 * @returns {Promise<Backend & { close?(): void }>}
 */
export async function widgetBackend(model) {
  const remote = new KernelBackend(model);
  try {
    const derivatives = async () => (await remote.call("derivatives", {})).arrays.content;
    const kernel = await WorkerKernel.unpack(model.get("module"), model.get("worker"), derivatives);
    return new LocalBackend(kernel, kernel.mechanics, { server: remote });
  } catch {
    return remote;
  }
}
