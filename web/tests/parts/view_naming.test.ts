// Keys that give names, and the order in which the program receives them, without a browser.

import { describe, expect, test } from "vitest";

import type { Command, State } from "../../src/view/data";
import { Namer, type Outcome } from "../../src/view/naming/namer";
import { namingKey } from "../../src/view/page/keys";
import type { Answer } from "../../src/view/session/model";
import { Observable } from "../../src/view/session/observable";
import { fakeState } from "../view/fake_frames";

const kNone = { shiftKey: false, ctrlKey: false, metaKey: false };
const pressed = (key: string, code: string, held: Partial<typeof kNone> = {}) => namingKey({ key, code, ...kNone, ...held });

describe("a key", () => {
  test("gives the name of its digit, on every keyboard", () => {
    expect(pressed("3", "Digit3")).toBe(3);
    expect(pressed('"', "Digit3")).toBe(3); // a row of digits that requires Shift
    expect([pressed("9", "Numpad9"), pressed("PageUp", "Numpad9")]).toEqual([9, 9]); // without Num Lock, too
    expect(pressed("3", "")).toBe(3); // a keyboard on a screen
  });

  test("accepts, undoes and begins to type", () => {
    expect([pressed("0", "Digit0"), pressed("Enter", "NumpadEnter"), pressed("Insert", "Numpad0")]).toEqual(Array(3).fill("accept"));
    expect([pressed("u", "KeyU"), pressed("Backspace", "Backspace"), pressed("z", "KeyZ", { ctrlKey: true })]).toEqual(Array(3).fill("undo"));
    expect(pressed("n", "KeyN")).toBe("type");
  });

  test("means something else with Shift and Ctrl, or by AltGr", () => {
    expect(pressed("!", "Digit1", { shiftKey: true })).toBe(null);
    expect(pressed("1", "Digit1", { ctrlKey: true })).toBe(null);
    expect(pressed("Z", "KeyZ", { ctrlKey: true, shiftKey: true })).toBe(null);
    expect(pressed("[", "Digit5")).toBe(null);
    expect(pressed("End", "End")).toBe(null);
  });
});

/** A program that answers when a test lets it, and notes what it received. */
class SlowProgram {
  readonly commands: Command[] = [];
  readonly outcomes: Outcome[] = [];
  readonly shownState: Observable<State | null>;
  readonly namer: Namer;
  private answers: ((answer: Answer) => void)[] = [];

  constructor(naming: Partial<State["naming"]> = {}) {
    const names = ["cup", "ball"].map((name) => ({ name, explorations: 0 }));
    this.shownState = new Observable<State | null>({
      ...fakeState(),
      exploration: 2,
      naming: { names, each: null, next: null, id: 20, given: null, last: null, ...naming },
    });
    const send = (command: Command) => {
      this.commands.push(command);
      return new Promise<Answer>((answer) => this.answers.push(answer));
    };
    this.namer = new Namer({ send, shownState: this.shownState }, (outcome) => this.outcomes.push(outcome));
  }

  get naming(): State["naming"] {
    return this.shownState.value!.naming;
  }

  show(part: Partial<State>): void {
    this.shownState.set({ ...this.shownState.value!, ...part });
  }

  async answer(answer: Answer = "done"): Promise<void> {
    await rest();
    this.answers.shift()!(answer);
    await rest();
  }
}

const rest = () => new Promise((done) => setTimeout(done));
const named = (value: string, id = 20) => ({ command: "name", label: "object", value, id });
const undone = (value: string, id = 20) => ({ ...named(value, id), command: "undo_name" });

describe("on a slow line", () => {
  test("a key that is pressed twice gives one name, and is confirmed by the program", async () => {
    const program = new SlowProgram();
    program.namer.giveKnown(1);
    program.namer.giveKnown(1);
    await rest();
    expect(program.outcomes).toEqual([]);
    await program.answer();
    expect(program.commands).toEqual([named("cup")]);
    expect(program.outcomes).toEqual([{ kind: "done", words: "Exploration 3: cup" }]);
  });

  test("names arrive in order, each for the exploration of its press", async () => {
    const program = new SlowProgram();
    program.namer.giveKnown(1);
    program.namer.giveKnown(2);
    program.show({ exploration: 3, naming: { ...program.naming, id: 30 } });
    program.namer.giveKnown(1);
    await rest();
    expect(program.commands).toEqual([named("cup")]);
    for (let i = 0; i < 3; i += 1) await program.answer();
    expect(program.commands).toEqual([named("cup"), named("ball"), named("cup", 30)]);
  });

  test("a proposal is accepted once, also before the new state arrives", async () => {
    const program = new SlowProgram({ each: 5, next: { name: "cup", number: 1 } });
    program.namer.accept();
    program.namer.accept();
    await program.answer();
    program.namer.accept();
    await rest();
    expect(program.commands).toEqual([named("cup")]);
    expect(program.outcomes.map(({ kind }) => kind)).toEqual(["refused", "done", "refused"]);
    expect(program.outcomes[2]!.words).toBe("Exploration 3 has the name “cup”.");
  });

  test("undo follows the name that it takes back, once", async () => {
    const program = new SlowProgram({ last: { exploration: 0, id: 10, label: "object", name: "ball" } });
    program.namer.giveKnown(1);
    program.namer.undo();
    program.namer.undo();
    await program.answer();
    await program.answer();
    expect(program.commands).toEqual([named("cup"), undone("cup")]);
    expect(program.outcomes.map(({ kind }) => kind)).toEqual(["done", "undone"]);
    program.namer.undo();
    await rest();
    expect(program.commands.at(-1)).toEqual(undone("ball", 10));
  });
});

// The next exploration has the index of one that is interrupted, and another identifier.
test("a name and its undo are for the exploration of the press, and for no other one", async () => {
  const program = new SlowProgram();
  program.namer.giveKnown(1);
  program.show({ naming: { ...program.naming, id: 21 } });
  program.namer.giveKnown(1);
  await program.answer("refused");
  await program.answer();
  program.namer.undo();
  await rest();
  expect(program.commands).toEqual([named("cup", 20), named("cup", 21), undone("cup", 21)]);
});

test("a name that is given, but not saved, is not called refused", async () => {
  const program = new SlowProgram();
  program.namer.giveKnown(1);
  await program.answer("unsaved");
  expect(program.outcomes).toEqual([{ kind: "unsaved", words: "Not saved: Exploration 3: cup" }]);
  program.namer.undo();
  await rest();
  expect(program.commands.at(-1)).toEqual(undone("cup"));
});

test("what is refused is not confirmed", async () => {
  const program = new SlowProgram();
  program.namer.giveKnown(1);
  await program.answer("refused");
  program.namer.giveKnown(3);
  program.namer.accept();
  program.namer.undo();
  program.show({ exploration: null });
  program.namer.giveKnown(1);
  expect(program.outcomes.every(({ kind }) => kind === "refused")).toBe(true);
  expect(program.outcomes.map(({ words }) => words)).toEqual([
    "Refused: Exploration 3: cup",
    "No name has the key 3.",
    "No name is proposed.",
    "There is no name to undo.",
    "There is no exploration to name.",
  ]);
});
