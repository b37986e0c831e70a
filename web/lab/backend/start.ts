// Where a page's answers come from: its own kernel where the browser can run it, else the server of the page, if it has one.

import { WorkerKernel } from "../../kernel/kernel.ts";
import { HttpBackend, KernelBackend, type Model } from "./backend.ts";
import { LocalBackend } from "./local_backend.ts";

/**
 * `folder`: of the script, with the module beside it; `server`: address of the page's server; `page`: what links
 * begin with.
 */
export async function backendOf(folder: URL, server: URL | null, page: URL): Promise<Backend> {
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
export function keepOffline(script: string) {
  // a page that is opened from a disk, or embedded, does without
  navigator.serviceWorker?.register(script).catch(() => {});
}

/** Of a notebook: its page computes by itself; what needs Python, and what the page may not do, its kernel does. */
export async function widgetBackend(model: Model): Promise<Backend & { close?(): void }> {
  const remote = new KernelBackend(model);
  try {
    const derivatives = async () => (await remote.call("derivatives", {})).arrays.content;
    const kernel = await WorkerKernel.unpack(model.get("module"), model.get("worker"), derivatives);
    return new LocalBackend(kernel, kernel.mechanics, { server: remote });
  } catch {
    return remote;
  }
}
