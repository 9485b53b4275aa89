// The view page against a server that speaks its protocol: what it shows, and to whom.

import { beforeEach, describe, expect, it } from "vitest";

import { parsed, sequenceColour } from "../../src/parts/maps/colour_maps";
import { digits, percent } from "../../src/parts/numbers";
import { fakeFrame, fakeState, kFrames } from "./fake_frames";
import { kTaxels } from "./fake_hand";
import {
  accessibilityViolations,
  bandColour,
  firstFrame,
  frameShown,
  rulesFor,
  screenshot,
  words,
} from "./view_browser";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage();
const ownWork = async () => Number(await view.page.locator(".status").getAttribute("data-usual"));

describe("what it shows", () => {
  beforeEach(() => view.open());

  it("takes the token out of the address and keeps it for this tab", async () => {
    expect(view.page.url()).not.toContain("token");
    await view.page.reload();
    await firstFrame(view.page);
    expect(await words(view.page, ".status-link")).toBe("connected");
  });

  it("shows the numbers of the frame", async () => {
    view.server.show(1, 40);
    await frameShown(view.page, 40);
    const frame = fakeFrame(1, 40);
    expect(await words(view.page, ".reading-answer")).toBe(frame.reading!.answer);
    expect(await words(view.page, ".confidence .number")).toBe(digits(frame.reading!.confidence));
    const nearest = frame.reading!.candidates[0]!.distance!;
    for (const { name, distance } of frame.reading!.candidates)
      expect(await words(view.page, `.candidate:has(.candidate-name:text-is("${name}")) .number`)).toBe(
        percent(nearest / distance!),
      );
    expect(await words(view.page, ".verdict")).toBe("✓ Right");
    expect(await view.page.locator(".panel-map .map-place").first().getAttribute("data-winner")).toBe(
      String(frame.maps["map"]!.winner),
    );
    await soon(() => view.page.locator("[data-channel=joints] .strip-value .number").allInnerTexts()).toEqual(
      frame.channels["joints"]!.map(digits),
    );
    const touch = frame.channels["touch"]!.map(Number);
    const at = touch.indexOf(Math.max(...touch));
    await soon(() => words(view.page, "[data-channel=touch] .strip-values")).toBe(
      `max ${digits(touch[at]!)} at ${kTaxels[at]}`,
    );
    expect(await words(view.page, ".time")).toBe("4.0 s / 5.9 s");
    await screenshot(view.page, "view-light");
  });

  it("colours the skin by contributions to the reading", async () => {
    const panel = view.page.locator(".panel-skin");
    view.server.show(1, 50);
    await frameShown(view.page, 50);
    const skin = panel.locator(".skin").first();
    await panel.getByRole("checkbox", { name: "contributions" }).check();
    const contributions = panel.locator(".contributions");
    expect(await skin.isVisible()).toBe(false);
    const given = fakeFrame(1, 50).reading!.contributions!;
    const values = given.channels["touch"]!;
    const end = Math.max(...values.map((value) => Math.abs(value ?? 0)));
    const fills = await contributions.locator("[data-cell]").evaluateAll((cells) => cells.map((cell) => cell.getAttribute("fill")));
    values.forEach((value, i) => {
      const share = value === null ? null : (value / end + 1) / 2;
      expect(fills[i], kTaxels[i]).toEqual(share === null ? "none" : expect.stringMatching(/^#/));
      if (share === null) return;
      const [is, exact] = [parsed(fills[i]!), parsed(sequenceColour(share))];
      is.forEach((part, k) => expect(Math.abs(part - exact[k]!)).toBeLessThan(6));
    });
    const reading = fakeFrame(1, 50).reading!;
    expect(await contributions.innerText()).toContain(`closer to ${reading.answer} than to ${given.other}`);
    const first = values.indexOf(values.find((value) => Math.abs(value ?? 0) === end)!);
    expect(await contributions.locator("li").first().innerText()).toContain(kTaxels[first]!);
    await screenshot(view.page, "view-contributions");
    for (const colorScheme of ["light", "dark"] as const) {
      await view.page.emulateMedia({ colorScheme });
      expect(await accessibilityViolations(view.page, rulesFor(colorScheme, 1280))).toEqual([]);
    }
    view.server.send("frame", { ...fakeFrame(1, 51), reading: { ...reading, contributions: null } });
    await soon(() => contributions.innerText()).toContain("There is no reading of two classes.");
    await panel.getByRole("checkbox", { name: "contributions" }).uncheck();
    expect(await contributions.isVisible()).toBe(false);
    expect(await skin.isVisible()).toBe(true);
  });

  it("shows missing values as missing, not as a sensor at rest", async () => {
    view.server.showWithout(1, 40, [0, 1]);
    await frameShown(view.page, 40);
    const fillOf = (taxel: number) => view.page.locator(`.panel-skin [data-cell="${taxel}"]`).getAttribute("fill");
    await soon(() => Promise.all([fillOf(0), fillOf(1)])).toEqual(["none", "none"]);
    expect(await fillOf(2)).toMatch(/^#/);
    const first = view.page.locator('.panel-skin [data-cell="0"]');
    await first.hover();
    expect(await words(view.page, ".panel-skin output")).toContain(`${kTaxels[0]}: –`);
    await screenshot(view.page, "view-missing");
  });

  it("shows the activity that another sense calls up beside the map's own", async () => {
    const state = fakeState();
    const module = state.graph!.modules.find(({ name }) => name === "map")!;
    const ports = { input: "crossed", target: "map" };
    const inputs = Object.entries(ports).map(([port, name]) => ({ port, module: name }));
    state.graph!.modules.push({ ...module, name: "expected", type: "association", inputs });
    view.server.change({ graph: state.graph });
    const frame = fakeFrame(1, 40);
    const values = frame.maps["map"]!.activity.map((_, neuron) => (neuron === 99 ? 0.02 : -0.01));
    frame.modules["expected"] = { shape: [225], values, folded: false };
    view.server.send("frame", frame);
    const recalled = view.page.locator(".panel-map [data-recalled=expected]");
    await soon(() => recalled.getAttribute("data-winner")).toBe("99");
    expect(await recalled.innerText()).toContain("called up by crossed");
    expect(await view.page.locator(".panel-map .map-place").first().getAttribute("data-winner")).toBe(
      String(frame.maps["map"]!.winner),
    );
    await screenshot(view.page, "view-recalled");
    view.server.change({ graph: fakeState().graph });
    await soon(() => recalled.count()).toBe(0);
  });

  it("shows all that was felt over the exploration, wherever it goes", async () => {
    await view.page.getByRole("button", { name: "joints", exact: true }).click(); // room for the other
    for (const exploration of [0, 2]) {
      view.server.show(exploration, kFrames - 1);
      await frameShown(view.page, kFrames - 1);
      const felt = Array.from({ length: kFrames }, (_, frame) =>
        fakeFrame(exploration, frame).channels["touch"]!.map(Number),
      );
      const most = Math.max(...felt.flat());
      for (const frame of [0, 27, 40, 57])
        for (const taxel of [0, 7, 31, 44]) {
          const [time, height] = [(frame + 0.5) / (kFrames - 1), (taxel + 0.5) / kTaxels.length];
          const step = Math.round((felt[frame]![taxel]! / most) * 255); // of the bands' colours
          const colour = parsed(sequenceColour(step / 255));
          await soon(() => bandColour(view.page, "touch", time, height)).toEqual(colour);
        }
    }
    view.server.show(2, 20);
    await frameShown(view.page, 20);
    await screenshot(view.page, "view-sought");
  });

  it("shows what the pointed cell of the map has now, and does not move the map", async () => {
    view.server.show(1, 40);
    await frameShown(view.page, 40);
    const box = () => view.page.locator(".panel-map .picture").boundingBox();
    const before = await box();
    await view.page.locator(".panel-map [data-cell='100']").hover();
    const { activity } = fakeFrame(1, 40).maps["map"]!;
    const expected = String(Number(activity[100]!.toPrecision(3)));
    expect(await words(view.page, ".panel-map .readout")).toContain(expected);
    expect(await box()).toEqual(before);
  });

  it("says the reading to those who listen", async () => {
    view.server.show(2, 59);
    const { answer } = fakeFrame(2, 59).reading!;
    await soon(() => view.page.locator(".reading-spoken").innerText()).toContain(answer);
  });

  it("drops frames that come faster than they are drawn", async () => {
    await view.server.flood(400, 200);
    await frameShown(view.page, 399 % kFrames);
    const { drawn, dropped, usual } = await view.page
      .locator(".status")
      .evaluate((line) => ({ ...(line as HTMLElement).dataset }));
    expect(Number(drawn) + Number(dropped)).toBe(401);
    expect(Number(dropped)).toBeGreaterThan(0);
    expect(Number(usual)).toBeGreaterThan(0);
    console.log(`own work ${usual} ms a frame; ${drawn} drawn, ${dropped} dropped`);
    // One measurement does not exclude that the machine was busy with something else.
    for (let more = 0; more < 3 && (await ownWork()) >= 15; more += 1) await view.server.flood(150, 50);
    expect(await ownWork()).toBeLessThan(15);
  });

  it("answers what a neuron stands for", async () => {
    await view.page.locator(".panel-map [data-cell='101']").click();
    await view.page.waitForSelector(".closer-answer");
    expect(await words(view.page, ".closer-answer")).toBe("Class: boccia cylinder");
    expect(await view.page.locator(".nearest li").count()).toBe(3);
    await screenshot(view.page, "view-neuron");
    await view.page.locator(".nearest button").first().click();
    await view.received({ command: "seek", exploration: 5, frame: 0 });
  });

  it("answers where a touch sensor of the hand matters", async () => {
    await view.page.waitForSelector(".scene[data-drawn]");
    const place = await view.page.evaluate(() => {
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
    const name = (await words(view.page, ".scene-readout")).split(":")[0]!;
    await view.page.mouse.click(place![0], place![1]);
    await view.page.waitForSelector(`.closer h3:text-is("Touch sensor ${name}")`);
    expect(await view.page.locator(".closer .map-picture [data-cell]").count()).toBe(225);
    await view.page.getByRole("button", { name: "Close" }).click();
    expect(await view.page.locator(".drawer").isVisible()).toBe(false);
  });
});

describe("for everyone", () => {
  for (const [colorScheme, width] of [
    ["light", 1366],
    ["dark", 1920],
    ["dark", 390],
  ] as const)
    it(`has no faults that axe finds, ${colorScheme}, ${width} pixels wide`, async () => {
      await view.open(undefined, { colorScheme, width });
      const rules = rulesFor(colorScheme, width);
      view.server.show(1, 50);
      await frameShown(view.page, 50);
      await view.page.locator(".panel-map [data-cell='101']").click();
      await view.page.waitForSelector(".closer-answer");
      await screenshot(view.page, `view-${width}-neuron`);
      expect(await accessibilityViolations(view.page, rules)).toEqual([]);
      await view.page.getByRole("button", { name: "Close" }).click();
      await screenshot(view.page, `view-${width}`);
      expect(await accessibilityViolations(view.page, rules)).toEqual([]);
    });

  it("fits narrow screens without scrolling sideways", async () => {
    for (const width of [1024, 600]) {
      if (width !== 1024) await view.leave();
      await view.open(undefined, { width });
      const [wide, tall] = await view.page.evaluate(() => [
        document.documentElement.scrollWidth,
        document.documentElement.scrollHeight,
      ]);
      expect(wide).toBeLessThanOrEqual(width);
      if (width >= 1000) expect(tall).toBeLessThanOrEqual(800);
      await screenshot(view.page, `view-${width}`);
    }
  });
});
