// A browser for the tests of the view, and what they read off the page.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { type Browser, chromium, type Page } from "playwright-core";

export const kWebFolder = fileURLToPath(new URL("..", import.meta.url));

/** Where `npm run build` has put the pages. */
export const kPages = process.env["SOMATO_WEB_OUT"] ?? join(kWebFolder, "dist");

const kScreenshots = process.env["SOMATO_SCREENSHOTS"] ?? join(kWebFolder, "dist", "screenshots");
const kDrawing = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

export function openBrowser(drawing: "3d" | "flat" = "3d"): Promise<Browser> {
  const args = ["--no-sandbox", ...(drawing === "3d" ? kDrawing : ["--disable-gpu", "--disable-3d-apis"])];
  return chromium.launch({ executablePath: process.env["SOMATO_CHROMIUM"] ?? "/usr/bin/chromium", args });
}

export async function screenshot(page: Page, name: string): Promise<void> {
  mkdirSync(kScreenshots, { recursive: true });
  await page.screenshot({ path: join(kScreenshots, `${name}.png`) });
}

/** Tells of everything that goes wrong in a page, for tests to expect none. */
export function complaints(page: Page): string[] {
  const heard: string[] = [];
  page.on("pageerror", (error) => heard.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && !/Failed to load resource|ERR_CONNECTION/.test(message.text())) heard.push(message.text());
  });
  return heard;
}

export async function words(page: Page, selector: string): Promise<string> {
  return (await page.locator(selector).first().innerText()).trim();
}

export async function firstFrame(page: Page): Promise<void> {
  await page.waitForSelector(".status[data-drawn]", { state: "attached" });
}

/** Waits until frame `frame` stands on the page. */
export async function frameShown(page: Page, frame: number): Promise<void> {
  await page.waitForFunction(
    (expected) => document.querySelector<HTMLInputElement>(".transport input[type=range]")?.getAttribute("aria-valuetext")?.startsWith(`frame ${expected} `),
    frame + 1,
  );
}
