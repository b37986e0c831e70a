// What a page answers with: the kernel that it computes with, and Python beside it where there is one.

import { WorkerKernel } from "../../kernel/kernel.ts";
import { Backend } from "./backend.ts";
import { Server, type Model, type NotebookKernel } from "./python.ts";

async function backend(loading: Promise<WorkerKernel>, beside: { base?: URL; python?: Python | null }) {
  const kernel = await loading.catch((error) => {
    throw typeof WebAssembly === "object" && !(error instanceof WebAssembly.CompileError) ? error : unable(error);
  });
  return new Backend(kernel, kernel.mechanics, beside);
}

/** Whether it is the page around that does not allow it, or the browser that cannot. */
const unable = ({ message }: Error) =>
  new Error(/content security|\bcsp\b/i.test(message) ? "page.wasm_forbidden" : "page.wasm_missing");

/**
 * `folder`: of the script, with the module beside it; `server`: address of the page's server; `base`: what links
 * begin with.
 */
export function backendOf(folder: URL, server: URL | null, base: URL) {
  return backend(WorkerKernel.load(folder), { base, python: server && new Server(server) });
}

/** Of a notebook: the module has come with it. `worker`: address of the worker's script. */
export function widgetBackend(model: Model, python: NotebookKernel, worker: string) {
  const kernel = WorkerKernel.unpack(model.get("module"), worker, () => python.derivatives());
  return backend(kernel, { python });
}

// The page without a network: the browser keeps its files once they have been there.
export function keepOffline(script: string) {
  // a page that is opened from a disk, or embedded, does without
  navigator.serviceWorker?.register(script).catch(() => {});
}
