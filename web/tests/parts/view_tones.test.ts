// Tones that confirm and refuse names, without a browser.

import { afterEach, expect, test, vi } from "vitest";

import { Tones } from "../../src/view/page/tones";

class FakeAudio {
  static readonly hertz: number[] = [];
  readonly state = "running";
  readonly currentTime = 0;
  readonly destination = {};

  createOscillator() {
    const frequency = { value: 0 };
    const source = { frequency, connect: (to: object) => to, start: () => FakeAudio.hertz.push(frequency.value), stop: () => undefined };
    return source;
  }

  createGain() {
    const gain = { setValueAtTime: () => undefined, exponentialRampToValueAtTime: () => undefined };
    return { gain, connect: (to: object) => to };
  }
}

function stubBrowser(): void {
  const stored = new Map<string, string>();
  vi.stubGlobal("AudioContext", FakeAudio);
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, value: string) => stored.set(key, value),
  });
}

const played = () => FakeAudio.hertz.splice(0);
afterEach(() => vi.unstubAllGlobals());

test("a name that is confirmed, undone or refused sounds different", () => {
  stubBrowser();
  const tones = new Tones();
  tones.play("done");
  const done = played();
  tones.play("undone");
  const undone = played();
  tones.play("refused");
  const refused = played();
  expect([done.length, undone.length, refused.length]).toEqual([1, 2, 2]);
  expect(undone[1]).toBeLessThan(undone[0]!);
  expect(refused[0]).toBeLessThan(undone[1]!);
});

test("tones that are switched off stay off when the page is opened again", () => {
  stubBrowser();
  const tones = new Tones();
  tones.turn(false);
  tones.play("done");
  const again = new Tones();
  again.play("refused");
  expect([again.isOn.value, played()]).toEqual([false, []]);
  again.turn(true);
  again.play("done");
  expect([new Tones().isOn.value, played().length]).toEqual([true, 1]);
});

test("a page without sound, or without storage, works", () => {
  const tones = new Tones();
  tones.play("done");
  expect([tones.isOn.value, played()]).toEqual([true, []]);
});
