import { fileURLToPath } from "node:url";

import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

import { contentSecurityPolicy } from "./content_security_policy";

// Two pages of the same parts: the report is one file that opens without a server, with the data
// put into it; the view is served as a page, a script and a style, so that no inline script need be
// allowed. SOMATO_WEB_OUT is the folder they are built into.
export default defineConfig(({ mode }) => {
  const isReport = mode === "report";
  return {
    root: fileURLToPath(new URL(".", import.meta.url)),
    base: "./",
    publicDir: false,
    plugins: isReport ? [viteSingleFile({ removeViteModuleLoader: true }), contentSecurityPolicy()] : [],
    build: {
      outDir: process.env.SOMATO_WEB_OUT ?? "dist",
      emptyOutDir: false,
      target: "es2022",
      modulePreload: false,
      chunkSizeWarningLimit: 2000,
      rollupOptions: {
        input: isReport ? "report.html" : "view.html",
        output: {
          entryFileNames: "[name].js",
          assetFileNames: "[name][extname]",
          inlineDynamicImports: true,
        },
      },
    },
  };
});
