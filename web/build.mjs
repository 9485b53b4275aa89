// Bundles the two pages by esbuild into the folder SOMATO_WEB_OUT: the report is one file that opens without a
// server, with the data put into it; the view is a page, a script and a style, so that no inline script need be
// allowed. Types are checked by the test web.types.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { build } from "esbuild";

const kOut = process.env["SOMATO_WEB_OUT"] ?? "dist";

mkdirSync(kOut, { recursive: true });
await Promise.all([buildReport(), buildView()]);

async function buildReport() {
  const { script, style } = await bundled("report");
  const page = htmlOf("report", `<script type="module">${script}</script>`, `<style>${style}</style>`);
  write("report.html", withPolicy(page, script));
}

async function buildView() {
  const { script, style } = await bundled("view");
  const link = '<link rel="stylesheet" href="./view.css" />';
  write("view.html", htmlOf("view", '<script type="module" src="./view.js"></script>', link));
  write("view.js", script);
  write("view.css", style);
}

/** @param {string} page */
async function bundled(page) {
  const { outputFiles } = await build({
    entryPoints: [`src/${page}/main.ts`],
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    loader: { ".woff2": "dataurl" },
    outdir: kOut,
    write: false,
  });
  const textOf = (/** @type {string} */ end) => outputFiles.find(({ path }) => path.endsWith(end))?.text ?? "";
  return { script: textOf(".js"), style: textOf(".css") };
}

/**
 * @param {string} page
 * @param {string} script
 * @param {string} style
 */
function htmlOf(page, script, style) {
  const html = readFileSync(`${page}.html`, "utf8");
  const styled = replaced(html, "  </head>", `    ${style}\n  </head>`);
  return replaced(styled, `<script type="module" src="/src/${page}/main.ts"></script>`, script);
}

/**
 * A strict content security policy for the report: its own script, known by its hash, and nothing from anywhere else.
 * Styles stand in the page and are set by Observable Plot, so they are allowed inline; pictures are made in the page.
 * @param {string} page
 * @param {string} script
 */
function withPolicy(page, script) {
  const hash = createHash("sha256").update(script, "utf8").digest("base64");
  const policy = [
    "default-src 'none'",
    `script-src 'sha256-${hash}'`,
    "style-src 'unsafe-inline'",
    "img-src data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const charset = '<meta charset="utf-8" />';
  return replaced(page, charset, `${charset}\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`);
}

/**
 * @param {string} text
 * @param {string} part
 * @param {string} by
 */
function replaced(text, part, by) {
  if (text.split(part).length !== 2) throw new Error(`A page does not contain "${part}" once`);
  return text.replace(part, () => by);
}

/**
 * @param {string} name
 * @param {string} text
 */
function write(name, text) {
  writeFileSync(join(kOut, name), text);
}
