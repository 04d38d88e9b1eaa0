import { defineConfig } from "vitest/config";
import { classes } from "./tools/classes";
import { offline } from "./tools/offline";
import { pack } from "./tools/pack";
import { preload } from "./tools/preload";
import { presets } from "./tools/presets";

export default defineConfig({
  // Relative, so that the built page works from any folder of any server.
  base: "./",
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 1000 },
  worker: { format: "es" },
  plugins: [classes(), presets(), preload(), offline(), pack()],
  test: { include: ["test/**/*.test.ts"], setupFiles: ["test/english.ts"], testTimeout: 120_000, hookTimeout: 120_000, fileParallelism: false, expect: { poll: { timeout: 30_000 } } },
});
