// Assembles the parts of the page: from left to right as the data go, the body, its skin, the code,
// the map and the name; below the body its readings over time.

import { element, fill } from "../../parts/dom";
import { CodePanel } from "../systems/code_panel";
import { Drawer } from "../systems/drawer";
import { HandPanel } from "../scene/hand_panel";
import { pageHeader } from "./header";
import { helpDialog } from "./help";
import { invitation } from "../naming/invitation";
import { listenToKeys } from "./keys";
import { LinkBanner } from "./link_banner";
import { MapPanel } from "../systems/map_panel";
import type { Model } from "../session/model";
import { NameKeys } from "../naming/name_keys";
import { NamePanel } from "../naming/name_panel";
import { Namer } from "../naming/namer";
import { Naming } from "../naming/naming";
import { NamingNote } from "../naming/naming_note";
import { problemBar } from "./problem_bar";
import { sessionRow } from "./session_row";
import { SkinPanel } from "../scene/skin_panel";
import { StatusLine } from "./status_line";
import { StripsPanel } from "../strips/strips_panel";
import { Tones } from "./tones";
import { Tour } from "./tour";
import { Transport } from "./transport";

export interface Page {
  status: StatusLine;
  hand: HandPanel;
}

export function buildPage(root: HTMLElement, model: Model, tryNow: () => void): Page {
  const status = new StatusLine(model);
  const help = helpDialog(status.root);
  const drawer = new Drawer(model);
  const hand = new HandPanel(model);
  const tones = new Tones();
  const note = new NamingNote(tones);
  const namer = new Namer(model, (outcome) => note.show(outcome));
  const naming = new Naming(model, namer, note);
  const keys = new NameKeys(model, namer, tones);
  const panels = [
    hand,
    new SkinPanel(model),
    new CodePanel(model, () => drawer.openGraph()),
    new MapPanel(model),
    new NamePanel(model, keys),
    new StripsPanel(model),
  ].map(({ panel }) => panel);
  const tour = new Tour(panels);
  const transport = new Transport(model);
  const messages = element("div", { class: "messages" }, [
    new LinkBanner(model, tryNow).root,
    problemBar(model),
    invitation(model),
  ]);
  const places = element("div", { class: "panels" }, [...panels.map((panel) => panel.root), drawer.root]);
  const header = pageHeader(model, { help: help.show, tour: () => tour.begin() });
  fill(root, [header, messages, places, sessionRow(model, naming), transport.root, help.root, tour.root]);
  const named = {
    get isOn() {
      return keys.isOn;
    },
    prepare: () => tones.prepare(),
    giveKnown: (key: number) => namer.giveKnown(key),
    accept: () => namer.accept(),
    undo: () => namer.undo(),
    type: () => naming.edit(true),
  };
  listenToKeys({ transport, panels, naming: named, help: help.show });
  model.shownLink.watch(({ kind }) => root.classList.toggle("without-program", kind !== "open"));
  return { status, hand };
}
