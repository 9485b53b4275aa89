// Measures the page of `somato view --demo` in a Chromium without a graphics processor:
//
//   node bench/view_page.mjs [--program build/release/somato] [--packages build/release/web/work]
//        [--size 1366x768] [--seconds 6] [--gl] [--kinds] [--pages FOLDER] [--screenshot FILE]
//
// It prints the time of the first picture of the body with values; the pictures of the body per second
// while the system is trained and while the second object is explored; and, from a trace, the work
// of the page's thread for each picture of the screen (processor time of scripts, style, layout,
// painting and collecting garbage), with --kinds also by kind. Without --gl, Chromium paints the page
// itself, as it does without a graphics processor; with it, a program for graphics processors that
// runs on the processor (SwiftShader) paints the page too, and not only the body. --packages names
// the folder in which the pages were built, with Playwright; --pages serves the pages in this folder
// instead of those in the program.

import { spawn } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";

const { values: options } = parseArgs({
  options: {
    program: { type: "string", default: "build/release/somato" },
    packages: { type: "string", default: "build/release/web/work" },
    size: { type: "string", default: "1366x768" },
    seconds: { type: "string", default: "6" },
    pages: { type: "string" },
    screenshot: { type: "string" },
    gl: { type: "boolean", default: false },
    kinds: { type: "boolean", default: false },
  },
});

const kChromium = process.env["SOMATO_CHROMIUM"] ?? "/usr/bin/chromium";
const kFlags = ["--no-sandbox", "--enable-unsafe-swiftshader"];
const kAllByGl = ["--use-gl=angle", "--use-angle=swiftshader"];
const kTicks = 100; // of the kernel, a second

const { chromium } = createRequire(join(resolve(options.packages), "package.json"))("playwright-core");
const pause = (seconds) => new Promise((done) => setTimeout(done, seconds * 1000));

/** The program and its address. */
function startView() {
  const program = spawn(options.program, ["view", "--demo"], { stdio: ["ignore", "pipe", "ignore"] });
  return new Promise((found, failed) => {
    let said = "";
    program.on("exit", () => failed(new Error(`somato view has ended: ${said}`)));
    program.stdout.on("data", (part) => {
      said += String(part);
      const address = /http:\/\/\S+token=\w+/.exec(said)?.[0];
      if (address !== undefined) found({ program, address });
    });
  });
}

/** In the page: the times of its pictures of the body, in ms since the navigation. */
function recordPictures() {
  globalThis.pictures = [];
  new MutationObserver((changes) => {
    const drawn = changes.some(({ target }) => target.matches?.(".scene[data-drawn]"));
    const shown = document.documentElement?.dataset["shown"] !== undefined;
    if (drawn && shown) globalThis.pictures.push(performance.now());
  }).observe(document, { subtree: true, childList: true, attributes: true, attributeFilter: ["data-drawn"] });
}

async function openPage(browser, address) {
  const [width, height] = options.size.split("x").map(Number);
  const page = await browser.newPage({ viewport: { width, height } });
  await page.addInitScript(recordPictures);
  if (options.pages !== undefined)
    for (const name of ["view.js", "view.css"])
      await page.route(`**/${name}`, (route) => route.fulfill({ path: join(options.pages, name) }));
  await page.goto(address);
  await page.waitForFunction(() => globalThis.pictures.length > 0, null, { timeout: 60_000, polling: 200 });
  return page;
}

const pictures = (page) => page.evaluate(() => globalThis.pictures);

function quantile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? Number.NaN;
}

const spread = (values, unit) =>
  `median ${quantile(values, 0.5).toFixed(1)} ${unit}, 99 % ${quantile(values, 0.99).toFixed(1)}, most ${Math.max(...values).toFixed(1)}`;

/** Seconds of the processor that each kind of process has used. */
function processorTimes() {
  const times = {};
  for (const id of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const words = readFileSync(`/proc/${id}/cmdline`, "utf8");
      const fields = readFileSync(`/proc/${id}/stat`, "utf8").split(") ").at(-1).split(" ");
      const kind = /--type=([\w-]+)/.exec(words)?.[1] ?? (words.includes("\0--demo") ? "somato" : null);
      if (kind === null && !words.includes("chromium")) continue;
      const seconds = (Number(fields[11]) + Number(fields[12])) / kTicks;
      times[kind ?? "browser"] = (times[kind ?? "browser"] ?? 0) + seconds;
    } catch {
      // It has ended.
    }
  }
  return times;
}

/** Waits for the beginning of the next exploration: between two, nothing moves. */
async function nextExploration(page) {
  const shown = () => document.documentElement.dataset["shown"].split(":")[0];
  const before = await page.evaluate(shown);
  await page.waitForFunction(
    (last) => document.documentElement.dataset["shown"].split(":")[0] !== last,
    before,
    { timeout: 60_000, polling: 100 },
  );
}

async function measurePictures(page, seconds, when) {
  const before = { pictures: (await pictures(page)).length, times: processorTimes() };
  await pause(seconds);
  const all = (await pictures(page)).slice(before.pictures);
  const after = processorTimes();
  console.log(`pictures of the body ${when}: ${(all.length / seconds).toFixed(1)} a second`);
  console.log(`  between two: ${spread(all.slice(1).map((time, i) => time - all[i]), "ms")}`);
  const shares = Object.entries(after).map(
    ([kind, time]) => `${kind} ${((time - (before.times[kind] ?? 0)) / seconds).toFixed(2)}`,
  );
  console.log(`  processors in use: ${shares.join(", ")}`);
}

const kKinds = ["FireAnimationFrame", "FunctionCall", "TimerFire", "UpdateLayoutTree", "Layout", "PrePaint", "Paint", "MinorGC", "MajorGC"];
const kCategories = ["devtools.timeline", "toplevel", "cc", "benchmark", "v8"];

/** The work of the page's thread between two pictures of the screen, from a trace. */
async function measureWork(browser, page, seconds) {
  await browser.startTracing(page, { categories: kCategories });
  await pause(seconds);
  const { traceEvents: events } = JSON.parse(String(await browser.stopTracing()));
  const first = events.find(({ name }) => name === "FireAnimationFrame");
  const own = events.filter(({ pid, tid, tdur }) => pid === first.pid && tid === first.tid && tdur !== undefined);
  const named = (wanted) => own.filter(({ name }) => name === wanted);
  const ends = named("ProxyMain::BeginMainFrame").map(({ ts, dur }) => ts + dur);
  const work = ends.map(() => 0);
  for (const { ts, tdur } of named("ThreadControllerImpl::RunTask")) {
    const at = ends.findIndex((end) => ts <= end);
    if (at >= 0) work[at] += tdur / 1000;
  }
  console.log(`work of the page for each of ${work.length} pictures of the screen: ${spread(work, "ms")}`);
  for (const name of options.kinds ? kKinds : []) {
    const times = named(name).map(({ tdur }) => tdur / 1000);
    if (times.length > 0) console.log(`  ${name}, ${times.length} times: ${spread(times, "ms")}`);
  }
}

const { program, address } = await startView();
const browser = await chromium.launch({ executablePath: kChromium, args: [...kFlags, ...(options.gl ? kAllByGl : [])] });
try {
  const page = await openPage(browser, address);
  console.log(`first picture: ${(await pictures(page))[0].toFixed(0)} ms after the navigation`);
  const seconds = Number(options.seconds);
  await measurePictures(page, seconds / 2, "during the training");
  await nextExploration(page);
  await measurePictures(page, seconds, "afterwards");
  await nextExploration(page);
  await measureWork(browser, page, seconds);
  const status = await page.evaluate(() => ({ ...document.querySelector(".status").dataset }));
  console.log(`by the page's own clock: ${JSON.stringify(status)}`);
  if (options.screenshot !== undefined) await page.screenshot({ path: options.screenshot });
} finally {
  await browser.close();
  program.kill();
}
