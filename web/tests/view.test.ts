// The view page against a server that speaks its protocol: what it shows, what it tells the program,
// how it fares without one.

import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, vi } from "vitest";

import type { State } from "../src/view/data";
import { digits } from "../src/view/numbers";
import { bodyState, fakeFrame, fakeState, kFrames } from "./fake_frames";
import { kTaxels } from "./fake_hand";
import { FakeServer } from "./fake_server";
import {
  accessibilityViolations, complaints, firstFrame, frameShown, kPages, launchBrowser, launchFlatBrowser, screenshot, words,
} from "./view_browser";

vi.setConfig({ testTimeout: 60_000, hookTimeout: 60_000 });

let browser: Browser;
let server: FakeServer;
let page: Page;
let heard: string[];

beforeAll(async () => {
  browser = await launchBrowser();
});
afterAll(() => browser.close());
afterEach(async () => {
  await page.close();
  await server.stop();
  expect(heard).toEqual([]);
});

async function open(state?: State, options: { colorScheme?: "dark" | "light"; width?: number } = {}): Promise<void> {
  server = new FakeServer(kPages, state);
  await server.start();
  const { colorScheme = "light", width = 1280 } = options;
  page = await browser.newPage({ viewport: { width, height: 800 }, colorScheme, reducedMotion: "reduce" });
  heard = complaints(page);
  await page.goto(server.address);
  if (server.state.explorations.length > 0) await firstFrame(page);
}

/** Expected before long: how soon depends on the machine. */
const soon = <T>(read: () => T) => expect.poll(read, { timeout: 15_000 });

async function told(command: object): Promise<void> {
  await soon(() => server.commands).toContainEqual(command);
}

describe("what it shows", () => {
  beforeEach(() => open());

  it("takes the token out of the address and keeps it for this tab", async () => {
    expect(page.url()).not.toContain("token");
    await page.reload();
    await firstFrame(page);
    expect(await words(page, ".status-link")).toBe("connected");
  });

  it("shows the numbers of the frame", async () => {
    server.show(1, 40);
    await frameShown(page, 40);
    const frame = fakeFrame(1, 40);
    expect(await words(page, ".reading-answer")).toBe(frame.reading!.answer);
    expect(await words(page, ".confidence .number")).toBe(digits(frame.reading!.confidence));
    for (const { name, distance } of frame.reading!.candidates)
      expect(await words(page, `.candidate:has(.candidate-name:text-is("${name}")) .number`)).toBe(digits(distance));
    expect(await page.locator(".panel-map .map-place").first().getAttribute("data-winner")).toBe(String(frame.maps["map"]!.winner));
    await soon(() => page.locator("[data-channel=joints] .strip-value .number").allInnerTexts()).toEqual(frame.channels["joints"]!.map(digits));
    const touch = frame.channels["touch"]!;
    const at = touch.indexOf(Math.max(...touch));
    expect(await words(page, "[data-channel=touch] .strip-values")).toBe(`most ${digits(touch[at]!)} at ${kTaxels[at]}`);
    expect(await words(page, ".time")).toBe("4.0 s / 5.9 s");
    await screenshot(page, "view-light");
  });

  it("shows what the pointed cell of the map has now", async () => {
    server.show(1, 40);
    await frameShown(page, 40);
    await page.locator(".panel-map [data-cell='100']").hover();
    const { activity } = fakeFrame(1, 40).maps["map"]!;
    expect(await words(page, ".panel-map .readout")).toContain(String(Number(activity[100]!.toPrecision(3))));
  });

  it("says the reading to those who listen", async () => {
    server.show(2, 59);
    await soon(() => page.locator(".reading-spoken").innerText()).toContain(fakeFrame(2, 59).reading!.answer);
  });

  it("drops frames that come faster than they are drawn", async () => {
    await server.flood(400, 200);
    await frameShown(page, 399 % kFrames);
    const { drawn, dropped, usual } = await page.locator(".status").evaluate((line) => ({ ...(line as HTMLElement).dataset }));
    expect(Number(drawn) + Number(dropped)).toBe(401);
    expect(Number(usual)).toBeLessThan(15);
    console.log(`own work ${usual} ms a frame; ${drawn} drawn, ${dropped} dropped`);
  });

  it("answers what a neuron stands for", async () => {
    await page.locator(".panel-map [data-cell='101']").click();
    await page.waitForSelector(".closer-answer");
    expect(await words(page, ".closer-answer")).toBe("It stands for boccia cylinder.");
    expect(await page.locator(".nearest li").count()).toBe(3);
    await screenshot(page, "view-neuron");
    await page.locator(".nearest button").first().click();
    await told({ command: "seek", exploration: 5, frame: 0 });
  });

  it("answers where a touch sensor of the hand matters", async () => {
    const place = await page.evaluate(() => {
      const scene = document.querySelector<HTMLElement>(".scene")!;
      const box = scene.getBoundingClientRect();
      for (let y = box.top + 4; y < box.bottom; y += 4)
        for (let x = box.left + 4; x < box.right; x += 4) {
          scene.dispatchEvent(new PointerEvent("pointermove", { clientX: x, clientY: y }));
          if (document.querySelector(".scene-readout")!.textContent !== "") return [x, y] as const;
        }
      return null;
    });
    expect(place).not.toBeNull();
    const name = (await words(page, ".scene-readout")).split(":")[0]!;
    await page.mouse.click(place![0], place![1]);
    await page.waitForSelector(`.closer h3:text-is("Touch sensor ${name}")`);
    expect(await page.locator(".closer .map-picture [data-cell]").count()).toBe(225);
  });
});

describe("what it tells the program", () => {
  it("plays, pauses, steps, scrubs and chooses", async () => {
    await open();
    await page.getByRole("button", { name: "Play", exact: true }).click();
    await told({ command: "play" });
    await page.getByRole("button", { name: "Pause", exact: true }).click();
    await told({ command: "pause" });
    await page.getByRole("button", { name: "Step forward" }).click();
    await told({ command: "step", frames: 1 });
    await page.getByRole("slider", { name: "Frame" }).fill("30");
    await told({ command: "seek", exploration: 0, frame: 30 });
    await frameShown(page, 30);
    await page.getByLabel("Speed").selectOption("4");
    await told({ command: "speed", speed: 4 });
    await page.getByLabel("Exploration", { exact: true }).selectOption("4");
    await told({ command: "seek", exploration: 4, frame: 0 });
    await page.getByLabel("System", { exact: true }).selectOption("shape_and_size");
    await told({ command: "system", name: "shape_and_size" });
  });

  it("gives a body something to explore", async () => {
    await open(bodyState());
    expect(await words(page, ".scene-note")).toContain("Nothing has been explored yet");
    await page.getByLabel("Object", { exact: true }).selectOption("block");
    await told({ command: "thing", name: "block" });
    await page.getByLabel("turn (°)").fill("15");
    await page.getByLabel("x (mm)").fill("-4");
    await page.getByLabel("y (mm)").focus();
    await told({ command: "placement", x: -4, y: 0, turn: 15 });
    await page.getByRole("button", { name: "Explore again" }).click();
    await told({ command: "explore" });
    server.refusal = "The hand cannot hold that.";
    await page.getByRole("button", { name: "Explore again" }).click();
    await page.getByRole("alert").getByText("The hand cannot hold that.").waitFor();
  });

  it("lets one watch a map learn, and stops it", async () => {
    await open();
    await page.getByRole("button", { name: "Learn", exact: true }).click();
    await told({ command: "train" });
    await page.getByText(/map learns: step \d+ of 1000, radius/).waitFor();
    await page.getByRole("button", { name: "Stop learning" }).click();
    await told({ command: "stop_training" });
    await screenshot(page, "view-learning");
    expect(await page.locator(".training .marker").count()).toBeGreaterThan(3);
  });

  it("needs no mouse", async () => {
    await open();
    const keys: [string, object][] = [
      ["ArrowRight", { command: "step", frames: 1 }], ["ArrowLeft", { command: "step", frames: -1 }],
      ["Shift+ArrowRight", { command: "step", frames: 10 }], ["ArrowUp", { command: "speed", speed: 2 }],
      ["End", { command: "seek", exploration: 0, frame: 59 }], ["]", { command: "seek", exploration: 1, frame: 0 }],
      ["Space", { command: "play" }],
    ];
    for (const [key, command] of keys) {
      await page.keyboard.press(key);
      await told(command);
    }
    await page.keyboard.press("5");
    expect(await page.evaluate(() => document.activeElement?.textContent)).toContain("Map");
    await page.locator(".panel-map svg[role=application]").focus();
    for (const key of ["ArrowDown", "ArrowRight", "Enter"]) await page.keyboard.press(key);
    await page.waitForSelector('.closer h3:text-is("Neuron in row 2, column 2")');
    await page.getByLabel("Touch sensor", { exact: true }).focus();
    await page.keyboard.press("ArrowDown");
    await page.waitForSelector(`.closer h3:text-is("Touch sensor ${kTaxels[0]}")`);
    await page.keyboard.press("?");
    await page.getByRole("dialog").waitFor();
    await page.keyboard.press("Escape");
    expect(await reachedByTab()).toEqual(await page.locator(kControls).count());
  });
});

const kControls = "button:visible:enabled, select:visible:enabled, input:visible:enabled:not([type=radio]), input[type=radio]:checked, [tabindex='0']:visible";

/** How many controls Tab comes by on its way around the page. */
async function reachedByTab(): Promise<number> {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  const seen = await page.evaluate(() => ((window as { seen?: Set<Element> }).seen = new Set<Element>()).size);
  for (let i = seen; i < 120; i += 1) {
    await page.keyboard.press("Tab");
    const known = await page.evaluate(() => {
      const { seen } = window as unknown as { seen: Set<Element> };
      const at = document.activeElement!;
      return at !== document.body && seen.size === seen.add(at).size;
    });
    if (known) break;
  }
  return page.evaluate(() => (window as unknown as { seen: Set<Element> }).seen.size);
}

describe("when things go wrong", () => {
  it("says that the connection is lost, and goes on when it is back", async () => {
    await open();
    await page.locator(".panel-map [data-cell='101']").click();
    await page.waitForSelector(".closer-answer");
    await server.stop();
    await page.getByText(/The program has ended or the connection is lost; trying again in [123] s/).waitFor();
    await screenshot(page, "view-lost");
    await server.start();
    await page.getByRole("button", { name: "Try now" }).click();
    await soon(() => words(page, ".status-link")).toBe("connected");
    await page.locator(".link-banner").waitFor({ state: "hidden" });
    server.show(0, 12);
    await frameShown(page, 12);
    expect(await words(page, ".closer-answer")).toBe("It stands for boccia cylinder.");
  });

  it("tries again by itself", async () => {
    await open();
    await server.stop();
    await page.getByText(/trying again in 3 s/).waitFor();
    await server.start();
    await soon(() => words(page, ".status-link")).toBe("connected");
  });

  it("says when its token is not the program's", async () => {
    await open();
    await page.goto(server.address.replace(server.token, "another"));
    await page.getByText(/Open the address that somato view printed/).waitFor();
  });

  it("shows the unfolded hand without WebGL", async () => {
    await open();
    await page.close();
    const flat = await launchFlatBrowser();
    page = await flat.newPage({ viewport: { width: 1280, height: 800 } });
    await page.goto(server.address);
    await firstFrame(page);
    expect(await words(page, ".scene-note")).toContain("cannot draw in three dimensions");
    server.show(1, 50);
    await frameShown(page, 50);
    await page.locator(".unfolded [data-cell='44']").click();
    await page.waitForSelector(`.closer h3:text-is("Touch sensor ${kTaxels[44]}")`);
    await screenshot(page, "view-no-webgl");
    await flat.close();
  });

  it("shows hostile words as words", async () => {
    const evil = `<img src=x onerror="document.title='gone'"><script>document.title='gone'</script>`;
    const state = fakeState();
    state.name = evil;
    state.explorations[0]!.labels["object"] = evil;
    state.systems[0]!.name = state.system = evil;
    state.label = state.problem = evil;
    state.channels[2]!.elements = state.channels[2]!.elements.map(() => evil);
    state.graph!.modules[4]!.text = evil;
    state.maps[0]!.classes = state.maps[0]!.classes.map(() => evil);
    await open(state);
    const frame = fakeFrame(0, 30);
    frame.reading = { answer: evil, confidence: 0.5, candidates: [{ name: evil, distance: 1 }] };
    server.send("frame", frame);
    await frameShown(page, 30);
    await page.locator(".panel-map [data-cell='101']").click();
    await page.waitForSelector(".closer-answer");
    expect(await words(page, ".reading-answer")).toBe(evil);
    expect(await page.locator("img, #view script").count()).toBe(0);
    expect(await page.title()).toContain("Somato view");
  });
});

describe("for everyone", () => {
  for (const colorScheme of ["light", "dark"] as const)
    it(`has no faults that axe finds, ${colorScheme}`, async () => {
      await open(undefined, { colorScheme });
      server.show(1, 50);
      await frameShown(page, 50);
      await page.locator(".panel-map [data-cell='101']").click();
      await page.waitForSelector(".closer-answer");
      await screenshot(page, `view-${colorScheme}-neuron`);
      expect(await accessibilityViolations(page)).toEqual([]);
    });

  it("fits narrow screens without scrolling sideways", async () => {
    for (const width of [1024, 600, 380]) {
      if (width !== 1024) await Promise.all([page.close(), server.stop()]);
      await open(undefined, { width });
      const [wide, tall] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
      expect(wide).toBeLessThanOrEqual(width);
      if (width >= 1000) expect(tall).toBeLessThanOrEqual(800);
      await screenshot(page, `view-${width}`);
    }
  });
});
