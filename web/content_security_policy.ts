// A strict content security policy for the report: its own script, known by its hash, and nothing
// from anywhere else. Styles stand in the page and are set by Observable Plot, so they are allowed
// inline; pictures are made in the page (data:).

import { createHash } from "node:crypto";

import type { Plugin } from "vite";

const kScript = /<script type="module"[^>]*>([\s\S]*?)<\/script>/g;

export function contentSecurityPolicy(): Plugin {
  return {
    name: "content-security-policy",
    enforce: "post",
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type === "asset" && file.fileName.endsWith(".html")) file.source = withPolicy(String(file.source));
      }
    },
  };
}

function withPolicy(page: string): string {
  const hashes = [...page.matchAll(kScript)].map(([, script]) => `'sha256-${hashOf(script ?? "")}'`);
  if (hashes.length === 0) throw new Error("report.html has no script of its own");
  const policy = [
    "default-src 'none'",
    `script-src ${hashes.join(" ")}`,
    "style-src 'unsafe-inline'",
    "img-src data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const tag = `<meta http-equiv="Content-Security-Policy" content="${policy}" />`;
  return page.replace(/<meta charset="utf-8" \/>/i, (charset) => `${charset}\n    ${tag}`);
}

function hashOf(script: string): string {
  return createHash("sha256").update(script, "utf8").digest("base64");
}
