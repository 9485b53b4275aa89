// The keys of the page, wherever one is, except where a control has its own use for them.

import type { Panel } from "./panel";
import type { Transport } from "./transport";

export interface KeyTargets {
  transport: Transport;
  panels: Panel[];
  help: () => void;
}

export const kKeys: [string, string][] = [
  ["Space", "play, pause"],
  ["← →", "one frame back, forward"],
  ["Shift ← →", "ten frames"],
  ["Home  End", "first, last frame"],
  ["↑ ↓", "faster, slower"],
  ["[  ]", "exploration before, after"],
  ["1 … 6", "go to a panel; again: fold it"],
  ["?", "this help"],
  ["in the hand", "arrows turn, Shift moves, + − nearer and farther, 0 as at first"],
  ["on a map", "arrows choose a neuron, Enter asks what it stands for"],
  ["Esc", "closes"],
];

export function listenToKeys(targets: KeyTargets): void {
  const actions = actionsOf(targets);
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
    if (document.querySelector("dialog[open]") !== null || takesKey(event)) return;
    const name = event.shiftKey && event.key.startsWith("Arrow") ? `Shift+${event.key}` : event.key;
    const action = actions[name] ?? visitOf(targets.panels, event.key);
    if (action === undefined) return;
    event.preventDefault();
    action();
  });
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

function visitOf(panels: Panel[], key: string): (() => void) | undefined {
  const panel = panels.find(({ number }) => String(number) === key);
  return panel && (() => panel.visit());
}

/** Whether what has the focus uses the key itself. */
function takesKey(event: KeyboardEvent): boolean {
  const at = event.target;
  if (!(at instanceof Element)) return false;
  if (at.matches("button, summary, a[href], [role=button]")) return event.key === " ";
  if (at.matches("input[type=checkbox]")) return event.key === " ";
  if (at.matches("input[type=range]")) return /^(Arrow|Home|End|Page)/.test(event.key);
  if (at.matches("input[type=radio]")) return /^(Arrow| )/.test(event.key);
  if (at.matches("select")) return event.key !== "?";
  return at.matches("input, textarea");
}
