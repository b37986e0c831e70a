// Keeps the page's files on the device, so that the lab opens without a network after the first visit.

const worker: any = self;
const VERSION = "hophoop-{version}"; // Python writes the version and the files, see hophoop/lab/export.py
const FILES = ["{files}"];

worker.addEventListener("install", (event: any) => {
  const kept = caches.open(VERSION).then((cache) => cache.addAll(FILES));
  event.waitUntil(kept.then(() => worker.skipWaiting()));
});

worker.addEventListener("activate", (event: any) => {
  const old = caches
    .keys()
    .then((names) => names.filter((name) => name.startsWith("hophoop-") && name !== VERSION))
    .then((names) => Promise.all(names.map((name) => caches.delete(name))));
  event.waitUntil(old.then(() => worker.clients.claim()));
});

worker.addEventListener("fetch", (event: any) => {
  const { request } = event;
  if (request.method !== "GET" || new URL(request.url).origin !== worker.location.origin) return;
  // the scenario is in the address: the page is the same for all of them
  const kept = caches.open(VERSION).then((cache) => cache.match(request, { ignoreSearch: true }));
  event.respondWith(kept.then((found) => found ?? fetch(request)));
});
