// The keyboard shortcuts of the page, except where a control uses the key itself.

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
  ["Home  End", "first frame, last frame"],
  ["↑ ↓", "faster, slower"],
  ["[  ]", "previous, next exploration"],
  ["1 … 6", "go to a panel; press again to collapse it"],
  ["?", "this help"],
  ["in the 3D picture", "arrows rotate, Shift moves, + − zoom, 0 resets the view"],
  ["on a map or the skin", "arrows select a cell, Enter shows its details"],
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

/** Whether the focused control uses the key. */
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
