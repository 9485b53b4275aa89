// Which map a picture shows: always a single one.

import { describe, expect, test } from "vitest";

import { firstMap, foldAccuracies, medianFold, shownMap } from "../../src/report/maps/shown_map";
import { shownOfMap } from "../../src/report/page/origin";
import { Selection } from "../../src/report/page/selection";
import type { SystemReport } from "../../src/report/page/unpacked";
import { hasPicture } from "../../src/parts/hands/thing_picture";
import { growingSystem, handSystem } from "./report_systems";

/** Six samples, tested by three trainings, of which the second is right for both samples and the third for none. */
function folded(protocol: string, withSaved: boolean): SystemReport {
  const hand = handSystem();
  const labels = ["a", "b", "a", "b", "a", "b"];
  const run = { seed: 1, recording: 0, winners: [0, 1, 2, 3, 4, 5], labels, predictions: ["a", "a", "b", "b", "a", "a"] };
  const folds = protocol === "leave_one_out" ? {} : { folds: [0, 0, 2, 1, 1, 2] };
  return {
    ...hand,
    protocols: [{ protocol, label: "object", samples: 6, metrics: {}, runs: [run, { ...run, seed: 2 }], ...folds }],
    samples: labels.map((object) => ({ object })),
    trained: withSaved ? { ...hand.trained!, winners: [9, 8, 7, 6, 5, 4] } : null,
  };
}

describe("with folds", () => {
  test("the first map is that of the saved system with all samples", () => {
    const selection = new Selection(folded("k_folds", true));
    const map = firstMap(selection)!;
    expect(map).toMatchObject({ kind: "saved", winners: [9, 8, 7, 6, 5, 4], samples: [0, 1, 2, 3, 4, 5] });
    expect(shownOfMap(map, selection).words).toBe("Trained on all 6 samples, by object, seed 1");
    expect(shownMap(selection)).toEqual(map);
    expect(selection.isOfSavedMap).toBe(true);
  });

  test("without it, it is the fold nearest the median, by name", () => {
    const system = folded("k_folds", false);
    const selection = new Selection(system);
    const [protocol] = system.protocols;
    expect(foldAccuracies(protocol!, protocol!.runs[0]!)).toEqual([0.5, 1, 0]);
    expect(medianFold(protocol!, protocol!.runs[0]!)).toBe(0);
    const map = firstMap(selection)!;
    expect(map).toMatchObject({ kind: "fold", samples: [0, 1], winners: [0, 1] });
    expect(shownOfMap(map, selection).words).toBe("Folds, by object, seed 1, fold 1 of 3, the fold nearest the median");
    selection.setFold(1);
    expect(shownMap(selection)).toMatchObject({ samples: [3, 4], winners: [3, 4] });
    expect(shownOfMap(shownMap(selection)!, selection).words).toBe("Folds, by object, seed 1, fold 2 of 3");
  });

  test("another seed than that of the saved system shows a fold of its own", () => {
    const selection = new Selection(folded("k_folds", true));
    selection.setRun(1);
    expect(shownMap(selection)).toMatchObject({ kind: "fold", samples: [0, 1] });
    expect(selection.isOfSavedMap).toBe(false);
    expect(firstMap(selection)!.kind).toBe("saved");
  });
});

test("with a map for each sample only that of the saved system is drawn", () => {
  expect(firstMap(new Selection(folded("leave_one_out", true)))!.kind).toBe("saved");
  expect(firstMap(new Selection(folded("leave_one_out", false)))).toBeNull();
});

test("folds of maps that grow have no map, because it is not stored", () => {
  const growing = growingSystem();
  const { runs } = growing.protocols[1]!;
  const protocol = { ...growing.protocols[1]!, folds: runs[0]!.winners.map((_, i) => i % 2) };
  expect(shownMap(new Selection({ ...growing, protocols: [protocol], trained: null }))).toBeNull();
  expect(shownMap(new Selection(growing))).toMatchObject({ kind: "run" });
});

test("a thing has a picture if its shape or the colour of its material is known", () => {
  const thing = handSystem().things[0]!;
  expect(hasPicture({ ...thing, shape: "sphere" })).toBe(true);
  expect(hasPicture({ ...thing, shape: "mug" })).toBe(false);
  expect(hasPicture({ ...thing, shape: null, colour: [1, 0, 0] })).toBe(true);
  expect(hasPicture({ ...thing, shape: null, colour: null, material: "felt" })).toBe(false);
});
