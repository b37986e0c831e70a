// What a page answers with, once the kernel that it computes with is there.

import type { WorkerKernel } from "../../kernel/kernel.ts";
import { Backend } from "./backend.ts";

/** `base`: what links begin with, where there are any to share. */
export async function backendOf(loading: Promise<WorkerKernel>, base: string | null) {
  const kernel = await loading.catch((error) => {
    throw typeof WebAssembly === "object" && !(error instanceof WebAssembly.CompileError) ? error : unable(error);
  });
  return new Backend(kernel, kernel.mechanics, base);
}

/** Whether it is the page around that does not allow it, or the browser that cannot. */
const unable = ({ message }: Error) =>
  new Error(/content security|\bcsp\b/i.test(message) ? "page.wasm_forbidden" : "page.wasm_missing");

// The page without a network: the browser keeps its files once they have been there.
export function keepOffline(script: string) {
  // a page that is opened from a disk, or embedded, does without
  navigator.serviceWorker
    ?.register(script)
    .then((found) => found.update())
    .catch(() => {});
}
