// The words of the view for unknown things and for explorations that were taught, without a browser.

import { describe, expect, test } from "vitest";

import type { State, Taught } from "../../src/view/data";
import { originWords, taughtFrom, taughtWords } from "../../src/view/naming/taught";
import { truthOf } from "../../src/view/naming/truth";
import { verdictOf } from "../../src/view/naming/verdict";
import { fakeFrame, fakeState, unknownFrame } from "../view/fake_frames";

const kTaught: Taught = { exploration: 4, name: "cup", before: "unknown", neuron: 17, problem: null };

/** A state whose exploration `index` has the name `name`. */
function named(index: number, name: string): State {
  const state = fakeState();
  state.explorations[index]!.labels = { object: name };
  return state;
}

/** A state with a class "cup", of which neuron 17 was taught and `more` were there before. */
function withCup(taught: Taught[], more: number[] = []): State {
  const state = { ...fakeState(), taught };
  const map = state.maps[0]!;
  map.classes.push("cup");
  for (const neuron of [17, ...more]) map.neuron_classes[neuron] = map.classes.length - 1;
  return state;
}

/** A frame of another exploration that is read as a cup. */
function cupFrame(exploration: number, winner = 0) {
  const frame = fakeFrame(exploration, 40);
  frame.maps["map"]!.winner = winner;
  return { ...frame, reading: { ...frame.reading!, answer: "cup" } };
}

describe("the verdict", () => {
  test("compares a name with the truth", () => {
    const { reading } = fakeFrame(1, 59);
    expect(verdictOf(reading!, fakeState(), 1)).toEqual({ isRight: true, words: "✓ Right" });
    expect(verdictOf(reading!, named(1, "cup"), 1)).toEqual({ isRight: false, words: "✗ Wrong: it is cup" });
    expect(verdictOf(reading!, { ...fakeState(), label: null }, 1)).toBe(null);
  });

  test("of an unknown thing depends on what was learned", () => {
    const { reading } = unknownFrame(1);
    expect(verdictOf(reading!, named(1, "cup"), 1)).toEqual({
      isRight: true,
      words: "✓ Right: cup has not been learned",
    });
    expect(verdictOf(reading!, fakeState(), 1)).toEqual({
      isRight: false,
      words: "✗ Not recognized: it is boccia cylinder",
    });
  });

  test("takes a class with the name unknown for a class", () => {
    const reading = { ...unknownFrame(1).reading!, novelty: null };
    expect(verdictOf(reading, named(1, "cup"), 1)?.words).toBe("✗ Wrong: it is cup");
  });

  test("is not given for an exploration without a name", () => {
    expect(truthOf(named(1, "unknown"), 1)).toBe(null);
    expect(verdictOf(unknownFrame(1).reading!, named(1, "unknown"), 1)).toBe(null);
  });
});

describe("an exploration that was taught", () => {
  test("is found by its index", () => {
    const state = withCup([kTaught]);
    expect([taughtFrom(state, 4), taughtFrom(state, 3)]).toEqual([kTaught, null]);
  });

  test("states what has changed", () => {
    const state = withCup([kTaught]);
    expect(taughtWords(kTaught, state)).toBe(
      "Learned as “cup” (read as unknown before): the neuron at row 2, column 3 represents it. No other neuron changed.",
    );
    expect(taughtWords({ ...kTaught, neuron: null }, state)).toBe("Counted as “cup”; no neuron changed.");
    expect(taughtWords({ ...kTaught, neuron: null, problem: "The map is full." }, state)).toBe("The map is full.");
    expect(taughtWords(kTaught, { ...state, graph: null })).toContain("a neuron represents it");
  });
});

describe("a name that was taught", () => {
  test("states the explorations that it was learned from", () => {
    expect(originWords(cupFrame(1), withCup([kTaught]))).toBe("Learned in this session, from exploration 5.");
    const again = { ...kTaught, exploration: 6, neuron: 18 };
    expect(originWords(cupFrame(1), withCup([kTaught, again], [18]))).toBe(
      "Learned in this session, from explorations 5 and 7.",
    );
  });

  test("is not that of another name, nor one that was only counted, nor the taught exploration", () => {
    expect(originWords(fakeFrame(1, 40), withCup([kTaught]))).toBe(null);
    const counted = { ...kTaught, exploration: 0, neuron: null };
    expect(originWords(cupFrame(1), withCup([counted]))).toBe(null);
    expect(originWords(cupFrame(1), withCup([kTaught, counted]))).toBe("Learned in this session, from exploration 5.");
    expect(originWords(cupFrame(4, 17), withCup([kTaught]))).toBe(null);
    expect(originWords({ ...cupFrame(1), reading: null }, withCup([kTaught]))).toBe(null);
  });

  test("that was known before is only that of the taught neuron", () => {
    const state = withCup([kTaught], [90]);
    expect(originWords(cupFrame(1, 90), state)).toBe(null);
    expect(originWords(cupFrame(1, 17), state)).toBe("Learned in this session, from exploration 5.");
  });
});
