/** The module begins to load with the page, and not when the page's script asks for it. */
import type { Plugin } from "vite";

const MODULE = /bifdiag_web_bg-[^/]*\.wasm$/;

export const preload = (): Plugin => ({
  name: "preload",
  transformIndexHtml: {
    order: "post",
    handler: (_html, { bundle }) =>
      Object.keys(bundle ?? {})
        .filter((name) => MODULE.test(name))
        .map((name) => ({ tag: "link", attrs: { rel: "preload", href: `./${name}`, as: "fetch", type: "application/wasm", crossorigin: "anonymous" }, injectTo: "head" as const })),
  },
});
