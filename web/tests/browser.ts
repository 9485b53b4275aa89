// Common code of the tests of pages: Debian's Chromium, the built pages, and where screenshots go.

import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

import { chromium, type Browser, type Page } from "playwright-core";

const kHere = fileURLToPath(new URL(".", import.meta.url));
const kBuilt = process.env["SOMATO_WEB_OUT"] ?? join(kHere, "..", "dist");

/** One that draws in three dimensions, by SwiftShader without a graphics processor; Chromium paints the page itself. */
export function sceneBrowser(): Promise<Browser> {
  return started("--enable-unsafe-swiftshader");
}

/** One that draws nothing in three dimensions; it permits a page to capture its tab without a question. */
export function flatBrowser(): Promise<Browser> {
  return started("--disable-gpu", "--disable-3d-apis", "--auto-accept-this-tab-capture");
}

const kStarted = new Map<string, Promise<Browser>>();

/** The files of tests that run in one process share their modules, and thus each browser, which ends with the process. */
function started(...args: string[]): Promise<Browser> {
  const key = args.join(" ");
  const browser = kStarted.get(key) ?? launch(args);
  kStarted.set(key, browser);
  return browser;
}

function launch(args: string[]): Promise<Browser> {
  const executablePath = process.env["SOMATO_CHROMIUM"] ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: ["--no-sandbox", ...args] });
}

/** The text of a page that `npm run build` made, such as "report.html". */
export function builtPage(name: string): string {
  const path = join(kBuilt, name);
  if (!existsSync(path)) throw new Error(`${path} is not there: run \`npm run build\` first.`);
  return readFileSync(path, "utf8");
}

/** JSON as it stands inside a script element: no "<" that could end it. */
export function asScriptText(data: unknown): string {
  return JSON.stringify(data).replaceAll("<", "\\u003c");
}

const kEmptyData = '<script type="application/json" id="report-data">null</script>';

/** Writes report.html with this text as its data, as `somato report` does; its address. */
export function writeReport(text: string): string {
  const page = builtPage("report.html");
  if (page.split(kEmptyData).length !== 2) throw new Error("report.html has no place for its data");
  const filled = page.split(kEmptyData).join(kEmptyData.replace("null", () => text));
  const path = join(mkdtempSync(join(tmpdir(), "somato-report-")), "report.html");
  writeFileSync(path, filled);
  return pathToFileURL(path).href;
}

export function screenshotPath(name: string): string {
  const folder = process.env["SOMATO_SCREENSHOTS"] ?? join(kBuilt, "screenshots");
  mkdirSync(folder, { recursive: true });
  return join(folder, `${name}.png`);
}

/** Rules whose findings depend on colours, and on sizes. */
export const kColourRules = ["color-contrast"];
export const kSizeRules = ["target-size", "scrollable-region-focusable"];

/**
 * The violations that axe-core finds in the page as it is now, by all its rules or those named: [] without any. The
 * first two cells of each map stand for the others, which are made alike and would take most of the time.
 */
export async function accessibilityViolations(page: Page, rules: string[] = []): Promise<string[]> {
  const source = readFileSync(join(kHere, "..", "node_modules", "axe-core", "axe.min.js"), "utf8");
  await page.evaluate(source);
  return page.evaluate(async (only) => {
    const { axe } = globalThis as unknown as { axe: Axe };
    interface Axe {
      run(options: object): Promise<{ violations: Violation[] }>;
    }
    interface Violation {
      id: string;
      nodes: { target: string[]; failureSummary?: string }[];
    }
    const alike = [...document.querySelectorAll("path[data-cell]:nth-of-type(n+3)")];
    const places = alike.map((cell) => document.createComment(cell.tagName));
    alike.forEach((cell, i) => cell.replaceWith(places[i]!));
    const { violations } = await axe.run(only.length > 0 ? { runOnly: only } : {});
    places.forEach((place, i) => place.replaceWith(alike[i]!));
    return violations.map(
      ({ id, nodes }) =>
        `${id}: ${nodes
          .slice(0, 3)
          .map((node) => `${node.target.join(" ")} (${node.failureSummary ?? ""})`)
          .join("; ")}`,
    );
  }, rules);
}
