// Assembles the parts of the page.

import { element, fill } from "../parts/dom";
import { CloserPanel } from "./closer_panel";
import { FilmButtons } from "./film";
import { HandPanel } from "./hand_panel";
import { pageHeader } from "./header";
import { helpDialog } from "./help";
import { invitation } from "./invitation";
import { listenToKeys } from "./keys";
import { LinkBanner } from "./link_banner";
import { MapPanel } from "./map_panel";
import type { Model } from "./model";
import { Naming } from "./naming";
import type { Panel } from "./panel";
import { problemBar } from "./problem_bar";
import { ReadingPanel } from "./reading_panel";
import { sessionFiles } from "./session_files";
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
  const strips = new StripsPanel(model);
  const columns = [
    [hand, strips],
    [new ReadingPanel(model), new CloserPanel(model)],
    [new MapPanel(model), new SystemPanel(model)],
  ].map((column) => column.map(({ panel }) => panel));
  const transport = new Transport(model);
  const status = new StatusLine(model);
  const messages = element("div", { class: "messages" }, [
    new LinkBanner(model, tryNow).root,
    problemBar(model),
    invitation(model),
  ]);
  const session = element("div", { class: "session" }, [
    new Naming(model).root,
    new FilmButtons(model).root,
    sessionFiles(model),
  ]);
  fill(root, [
    pageHeader(model, help.show),
    messages,
    arrange(columns),
    session,
    transport.root,
    status.root,
    help.root,
  ]);
  listenToKeys({ transport, panels: columns.flat(), help: help.show });
  model.shownLink.watch(({ kind }) => root.classList.toggle("without-program", kind !== "open"));
  return { status, hand };
}

/** Sensor readings are on the left, the reading of the system in the middle, its modules on the right. */
function arrange(columns: Panel[][]): HTMLElement {
  const made = columns.map((panels) =>
    element(
      "div",
      { class: "column" },
      panels.map(({ root }) => root),
    ),
  );
  return element("div", { class: "panels" }, made);
}
