import { defineConfig } from "vite";

// The page is one script, one sheet and their chunks, with names made of their contents: the server embeds them.
export default defineConfig({
  base: "./",
  build: { target: "es2022", outDir: "dist", emptyOutDir: true, sourcemap: false, modulePreload: { polyfill: false } },
  server: { proxy: { "/api": "http://127.0.0.1:7878" } },
});
