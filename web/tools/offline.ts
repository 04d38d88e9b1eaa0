/** A service worker that keeps the built page: after one visit it opens without a network, exports too. */
import { createHash } from "node:crypto";
import type { Plugin } from "vite";

/** Names of built files change with what is in them; the page itself is asked for anew while there is a network. */
const worker = (files: string[], version: string) => `const KEPT = "bifdiag ${version}";
addEventListener("install", (event) => event.waitUntil(caches.open(KEPT).then((kept) => kept.addAll(${JSON.stringify(files)})).then(() => skipWaiting())));
addEventListener("activate", (event) => event.waitUntil(caches.keys().then((names) => Promise.all(names.filter((name) => name !== KEPT).map((name) => caches.delete(name)))).then(() => clients.claim())));
addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== location.origin) return;
  const kept = () => caches.open(KEPT).then((cache) => cache.match(event.request, { ignoreSearch: true, ignoreVary: true }));
  event.respondWith(event.request.mode === "navigate" ? fetch(event.request).catch(kept) : kept().then((found) => found ?? fetch(event.request)));
});
`;

export function offline(): Plugin {
  return {
    name: "offline",
    apply: "build",
    generateBundle(_, bundle) {
      const files = Object.keys(bundle).sort();
      const version = createHash("sha256").update(files.join()).digest("hex").slice(0, 12);
      this.emitFile({ type: "asset", fileName: "offline.js", source: worker(["./", ...files.map((file) => `./${file}`)], version) });
    },
  };
}
