<<<<<<< HEAD
/* Built from web/site/service_worker.ts by esbuild 0.28.2; sources 08fa2295d98ccdf4a2c3989ef7759ab2 */
=======
/* Built from web/site/service_worker.ts by esbuild 0.28.2; sources 9cefdac4c0913cb5710548f3f45c9570 */
>>>>>>> main
var o=self,s="hophoop-{version}",a=["{files}"];o.addEventListener("install",i=>{let e=caches.open(s).then(n=>n.addAll(a));i.waitUntil(e.then(()=>o.skipWaiting()))});o.addEventListener("activate",i=>{let e=caches.keys().then(n=>n.filter(t=>t.startsWith("hophoop-")&&t!==s)).then(n=>Promise.all(n.map(t=>caches.delete(t))));i.waitUntil(e.then(()=>o.clients.claim()))});o.addEventListener("fetch",i=>{let{request:e}=i;if(e.method!=="GET"||new URL(e.url).origin!==o.location.origin)return;let n=caches.open(s).then(t=>t.match(e,{ignoreSearch:!0}));i.respondWith(n.then(t=>t??fetch(e)))});
