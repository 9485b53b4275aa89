// The view page when things go wrong: without the program, without a token, without WebGL.

import { describe, expect, it } from "vitest";

import { fakeFrame, fakeState } from "./fake_frames";
import { kTaxels } from "./fake_hand";
import { firstFrame, flatBrowser, frameShown, screenshot, words } from "./view_browser";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage(flatBrowser);

describe("when things go wrong", () => {
  it("says that the connection is lost, and continues when it is back", async () => {
    await view.open();
    await view.page.locator(".panel-map [data-cell='101']").click();
    await view.page.waitForSelector(".closer-answer");
    await view.server.stop();
    await view.page
      .getByText(/The program has ended or the connection is lost; trying again in [123] s/)
      .waitFor();
    await screenshot(view.page, "view-lost");
    await view.server.start();
    await view.page.getByRole("button", { name: "Try now" }).click();
    await soon(() => words(view.page, ".status-link")).toBe("connected");
    await view.page.locator(".link-banner").waitFor({ state: "hidden" });
    view.server.show(0, 12);
    await frameShown(view.page, 12);
    expect(await words(view.page, ".closer-answer")).toBe("Class: boccia cylinder");
  });

  it("tries again by itself", async () => {
    await view.open();
    await view.server.stop();
    await view.page.getByText(/trying again in 3 s/).waitFor();
    await view.server.start();
    await soon(() => words(view.page, ".status-link")).toBe("connected");
  });

  it("does not take silence for a connection", async () => {
    await view.serve();
    view.server.silent = true;
    await view.renew();
    await view.page.clock.install();
    await view.page.goto(view.server.address);
    await firstFrame(view.page);
    await view.page.clock.fastForward(7000);
    await view.page.locator(".link-banner", { hasText: "connection is lost" }).waitFor();
    await view.page.clock.fastForward(4000);
    await soon(() => words(view.page, ".status-link")).toBe("connected");
    await view.renew(); // with the browser's own clock
  });

  it("says by how much it is behind on a slow line", async () => {
    await view.serve();
    view.server.silent = true;
    await view.renew();
    await view.page.clock.install();
    await view.page.goto(view.server.address);
    await firstFrame(view.page);
    const age = view.page.locator(".age");
    view.server.send("ping", { viewer: 7, number: 1, waited: 0 });
    await soon(() => view.server.seen).toEqual(["7:1"]);
    await view.page.clock.fastForward(4000);
    await soon(() => words(view.page, ".age")).toMatch(/^[4-9] s behind$/);
    view.server.show(0, 12);
    await frameShown(view.page, 12);
    view.server.send("ping", { viewer: 7, number: 2, waited: 60 }); // it was sent just now
    await soon(() => view.server.seen).toEqual(["7:1", "7:2"]);
    await age.waitFor({ state: "hidden" });
    await view.renew(); // with the browser's own clock
  });

  it("says when its token is not the program's", async () => {
    await view.open();
    await view.page.goto(view.server.address.replace(view.server.token, "another"));
    await view.page.getByText(/Open the address printed by somato view/).waitFor();
  });

  it("shows the skin without WebGL", async () => {
    await view.open();
    await soon(() => words(view.page, ".scene-note")).toContain("does not support WebGL");
    view.server.show(1, 50);
    await frameShown(view.page, 50);
    await view.page.locator(".skin-place [data-cell='44']").click();
    await view.page.waitForSelector(`.closer h3:text-is("Touch sensor ${kTaxels[44]}")`);
    await screenshot(view.page, "view-no-webgl");
  });

  it("shows a pad in place of a body that is not known", async () => {
    const elements = Array.from({ length: 16 }, (_, i) => `t${Math.floor(i / 4)}${i % 4}`);
    const state = fakeState();
    const touch = { name: "touch", unit: "N", elements, shape: [16] };
    state.channels = [state.channels[2]!, touch];
    await view.serve(state);
    view.server.setScene(null);
    await view.page.goto(view.server.address);
    await firstFrame(view.page);
    const frame = fakeFrame(0, 30);
    frame.channels["touch"] = elements.map((_, i) => (i === 5 ? 4 : 0));
    view.server.send("frame", frame);
    await view.page.waitForSelector(".panel-hand .skin-place .lit[data-cell='5']");
    const places = await view.page.locator(".panel-hand .skin-place [data-cell]").evaluateAll((cells) =>
      cells.map((cell) => cell.getBoundingClientRect()).map(({ x, y }) => [Math.round(x), Math.round(y)]),
    );
    expect([0, 1].map((axis) => new Set(places.map((place) => place[axis])).size)).toEqual([4, 4]);
    expect(await words(view.page, ".panel-skin .sense-row .candidate-name")).toBe("finger1_proximal");
    view.server.change({ channels: [state.channels[0]!] });
    await view.page.waitForSelector(".panel-hand .sense-row");
    expect(await view.page.locator(".panel-skin").isHidden()).toBe(true);
  });

  it("describes the neuron that is selected, although the focus has pointed at the first", async () => {
    await view.open();
    await view.page.locator(".panel-map .map-place svg").focus();
    await soon(() => words(view.page, ".panel-map .readout")).toContain("row 1, column 1");
    await view.page.locator(".panel-map [data-cell='101']").dispatchEvent("click"); // as a finger does
    await soon(() => words(view.page, ".panel-map .readout")).not.toContain("row 1, column 1");
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
    await view.open(state);
    const frame = fakeFrame(0, 30);
    frame.reading = { answer: evil, confidence: 0.5, novelty: null, candidates: [{ name: evil, distance: 1 }], contributions: { other: evil, unit: evil, channels: { [evil]: [1] } } };
    view.server.send("frame", frame);
    await frameShown(view.page, 30);
    await view.page.locator(".panel-map [data-cell='101']").click();
    await view.page.waitForSelector(".closer-answer");
    expect(await words(view.page, ".reading-answer")).toBe(evil);
    expect(await view.page.locator("img, #view script").count()).toBe(0);
    expect(await view.page.title()).toContain("Somato view");
  });
});
