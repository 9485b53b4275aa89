// The keyboard shortcuts of the page, except where a control uses the key itself.

import type { Panel } from "./panel";
import type { Transport } from "./transport";

/** The actions of the keys of names, while `isOn`. */
export interface NamingTarget {
  readonly isOn: boolean;
  prepare(): void;
  giveKnown(key: number): void;
  accept(): void;
  undo(): void;
  type(): void;
}

export interface KeyTargets {
  transport: Transport;
  panels: Panel[];
  naming: NamingTarget;
  help: () => void;
}

export const kKeys: [string, string][] = [
  ["Space", "play, pause"],
  ["← →", "one frame back, forward"],
  ["Shift ← →", "ten frames"],
  ["Home  End", "first frame, last frame"],
  ["↑ ↓", "faster, slower"],
  ["[  ]", "previous, next exploration"],
  ["1 … 9", "give the name with this number, while Names by keys is open in the panel Name"],
  ["0  Enter", "give the name that is proposed by the plan"],
  ["n", "type a name"],
  ["u  Backspace  Ctrl Z", "undo the last name"],
  ["Shift 1 … 6", "go to a panel; press again to collapse it. Without Shift, while Names by keys is closed"],
  ["?", "this help"],
  ["in the 3D picture", "arrows rotate, Shift moves, + − zoom, 0 resets the view"],
  ["on a map or the skin", "arrows select a cell, Enter shows its details"],
  ["Esc", "closes"],
];

export function listenToKeys(targets: KeyTargets): void {
  const actions = actionsOf(targets);
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.altKey || isModal() || takesKey(event)) return;
    const key = targets.naming.isOn ? namingKey(event) : null;
    if (key === null && (event.ctrlKey || event.metaKey)) return;
    const name = event.shiftKey && event.key.startsWith("Arrow") ? `Shift+${event.key}` : event.key;
    const action = key === null ? (actions[name] ?? visitOf(targets.panels, event)) : () => act(targets.naming, key, event);
    if (action === undefined) return;
    event.preventDefault();
    action();
  });
}

function isModal(): boolean {
  return document.querySelector("dialog[open], .tour:not([hidden])") !== null;
}

export type NamingKey = number | "accept" | "undo" | "type";
type Pressed = Pick<KeyboardEvent, "key" | "code" | "shiftKey" | "ctrlKey" | "metaKey">;

/** The meaning of a pressed key while names are given by keys; null: none. */
export function namingKey(event: Pressed): NamingKey | null {
  const letter = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) return letter === "z" && !event.shiftKey ? "undo" : null;
  if (event.shiftKey) return null;
  if (event.key === "Enter") return "accept";
  if (letter === "u" || event.key === "Backspace") return "undo";
  if (letter === "n") return "type";
  const digit = digitOf(event);
  return digit === 0 ? "accept" : digit;
}

/**
 * The digit by its place on the keyboard: a row of digits may require Shift, and a numeric pad give
 * arrows. A key that writes something else by AltGr is no digit.
 */
function digitOf({ key, code }: Pick<Pressed, "key" | "code">): number | null {
  const digit = /^(?:Digit|Numpad)(\d)$/.exec(code)?.[1] ?? /^\d$/.exec(key)?.[0];
  return digit === undefined || key === "[" || key === "]" || key === "?" ? null : Number(digit);
}

/** A key that is held gives one name. */
function act(naming: NamingTarget, key: NamingKey, { repeat }: KeyboardEvent): void {
  if (repeat) return;
  naming.prepare();
  if (key === "accept") naming.accept();
  else if (key === "undo") naming.undo();
  else if (key === "type") naming.type();
  else naming.giveKnown(key);
}

function actionsOf({ transport, help }: KeyTargets): Record<string, (() => void) | undefined> {
  return {
    " ": () => transport.togglePlaying(),
    ArrowLeft: () => transport.step(-1),
    ArrowRight: () => transport.step(1),
    "Shift+ArrowLeft": () => transport.step(-10),
    "Shift+ArrowRight": () => transport.step(10),
    ArrowUp: () => transport.faster(1),
    ArrowDown: () => transport.faster(-1),
    Home: () => transport.end(0),
    End: () => transport.end(1),
    "[": () => transport.move(-1),
    "]": () => transport.move(1),
    "?": help,
  };
}

function visitOf(panels: Panel[], event: KeyboardEvent): (() => void) | undefined {
  const panel = panels.find(({ number }) => number === digitOf(event));
  return panel && (() => panel.visit());
}

/** Whether the focused control uses the key. */
function takesKey(event: KeyboardEvent): boolean {
  const at = event.target;
  if (!(at instanceof Element)) return false;
  if (event.key === "Enter" && at.matches("button, summary, a[href], input, select, [tabindex='0']")) return true;
  if (at.matches("button, summary, a[href], [role=button]")) return event.key === " ";
  if (at.matches("input[type=checkbox]")) return event.key === " ";
  if (at.matches("input[type=range]")) return /^(Arrow|Home|End|Page)/.test(event.key);
  if (at.matches("input[type=radio]")) return /^(Arrow| )/.test(event.key);
  if (at.matches("select")) return event.key !== "?";
  return at.matches("input, textarea");
}
