// Common readings of the view's page for its tests.

import { fileURLToPath } from "node:url";

import type { Page } from "playwright-core";

import { kColourRules, kSizeRules, screenshotPath } from "../browser";

export { accessibilityViolations, flatBrowser, sceneBrowser } from "../browser";

/** Where `npm run build` has put the pages. */
export const kPages = process.env["SOMATO_WEB_OUT"] ?? fileURLToPath(new URL("../../dist", import.meta.url));

/** The dark and wide page differs from the light one, which all rules check, in colours and sizes. */
export function rulesFor(colorScheme: "dark" | "light", width: number): string[] {
  return colorScheme === "dark" && width > 1000 ? [...kColourRules, ...kSizeRules] : [];
}

export async function screenshot(page: Page, name: string): Promise<void> {
  await page.screenshot({ path: screenshotPath(name) });
}

/** Collects everything that goes wrong in a page, for tests to expect nothing. */
export function complaints(page: Page): string[] {
  const problems: string[] = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && !/Failed to load resource|ERR_CONNECTION/.test(message.text()))
      problems.push(message.text());
  });
  return problems;
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
    (expected) =>
      document
        .querySelector<HTMLInputElement>(".transport input[type=range]")
        ?.getAttribute("aria-valuetext")
        ?.startsWith(`frame ${expected} `),
    frame + 1,
  );
}

/** The colour of a strip's band, as drawn: `time` and `height` are shares of the plot. */
export function bandColour(page: Page, channel: string, time: number, height: number): Promise<number[]> {
  return page.evaluate(
    ([name, across, down]) => {
      const strip = document.querySelector(`[data-channel=${name}]`)!;
      const canvas = strip.querySelector("canvas")!;
      const plot = strip.querySelector(".u-over")!.getBoundingClientRect();
      const whole = canvas.getBoundingClientRect();
      const x = plot.left - whole.left + across * plot.width;
      const y = plot.top - whole.top + down * plot.height;
      const pixel = canvas.getContext("2d")!.getImageData(x, y, 1, 1);
      return [...pixel.data].slice(0, 3);
    },
    [channel, time, height] as const,
  );
}
