// Keeps the page's files on the device, so that the lab opens without a network after the first visit.

const worker: any = self;
// of this lab, as others may be at the same origin; Python writes the version and the files, see hophoop/lab/export.py
const OWN = `hophoop ${worker.registration.scope} `;
const VERSION = `${OWN}{version}`;
const FILES = ["{files}"];

worker.addEventListener("install", (event: any) => {
  // the files of this version, not those that the browser still holds
  const files = FILES.map((file) => new Request(file, { cache: "reload" }));
  const kept = caches.open(VERSION).then((cache) => cache.addAll(files));
  event.waitUntil(kept.then(() => worker.skipWaiting()));
});

worker.addEventListener("activate", (event: any) => {
  const old = caches
    .keys()
    .then((names) => names.filter((name) => name.startsWith(OWN) && name !== VERSION))
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
