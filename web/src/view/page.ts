// Puts the parts of the page together.

import { element, fill } from "../parts/dom";
import { CloserPanel } from "./closer_panel";
import { HandPanel } from "./hand_panel";
import { pageHeader } from "./header";
import { helpDialog } from "./help";
import { listenToKeys } from "./keys";
import { LinkBanner } from "./link_banner";
import { MapPanel } from "./map_panel";
import type { Model } from "./model";
import type { Panel } from "./panel";
import { problemBar } from "./problem_bar";
import { ReadingPanel } from "./reading_panel";
import { StatusLine } from "./status_line";
import { StripsPanel } from "./strips_panel";
import { SystemPanel } from "./system_panel";
import { Transport } from "./transport";

export interface Page {
  status: StatusLine;
  hand: HandPanel;
}

export function buildPage(root: HTMLElement, model: Model, tryNow: () => void): Page {
  const help = helpDialog();
  const hand = new HandPanel(model);
  const panels = [hand, new ReadingPanel(model), new CloserPanel(model), new MapPanel(model), new StripsPanel(model),
    new SystemPanel(model)].map(({ panel }) => panel);
  const transport = new Transport(model);
  const status = new StatusLine(model);
  fill(root, [pageHeader(model, help.show), new LinkBanner(model, tryNow).root, problemBar(model), arrange(panels),
    transport.root, status.root, help.root]);
  listenToKeys({ transport, panels, help: help.show });
  model.shownLink.watch(({ kind }) => root.classList.toggle("without-program", kind !== "open"));
  return { status, hand };
}

/** Above: hand, reading and closer look, map. Below: strips and system. */
function arrange(panels: Panel[]): HTMLElement {
  const [hand, reading, closer, map, strips, system] = panels.map(({ root }) => root);
  const middle = element("div", { class: "column" }, [reading ?? null, closer ?? null]);
  const above = element("div", { class: "row row-above" }, [hand ?? null, middle, map ?? null]);
  const below = element("div", { class: "row row-below" }, [strips ?? null, system ?? null]);
  return element("div", { class: "panels" }, [above, below]);
}
