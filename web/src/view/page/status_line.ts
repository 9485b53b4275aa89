// The state of the page: its connection, and its time per frame.

import { element } from "../../parts/dom";
import { fixed } from "../../parts/numbers";
import type { Link } from "../session/connection";
import type { Work } from "../session/frame_loop";
import type { Model } from "../session/model";

export class StatusLine {
  readonly root: HTMLElement;
  private readonly link = element("span", { class: "status-link" });
  private readonly clients = element("span");
  private readonly frames = element("span", { class: "status-frames" }, ["no frames yet"]);
  private readonly time = element("span", { class: "status-time" });
  private updated = 0;

  constructor(model: Model) {
    const label = { class: "status", role: "group", "aria-label": "State of the page" };
    this.root = element("div", label, [this.link, this.clients, this.frames, this.time]);
    model.shownLink.watch((link) => this.showLink(link));
    model.shownState.watch((state) => {
      const others = state === null ? 0 : state.clients;
      this.clients.textContent = others === 1 ? "1 viewer" : `${others} viewers`;
      this.clients.hidden = state === null;
    });
  }

  /** The text changes a few times per second; the data attributes always have the newest numbers. */
  work(work: Work): void {
    const { drawn, dropped, usual, most, drawing } = work;
    Object.assign(this.root.dataset, {
      drawn,
      dropped,
      usual: usual.toFixed(2),
      most: most.toFixed(2),
      drawing: drawing.toFixed(2),
    });
    const now = performance.now();
    if (now - this.updated < 250) return;
    this.updated = now;
    this.frames.textContent = `frames: ${drawn} drawn, ${dropped} dropped`;
    this.time.textContent = `page ${fixed(usual, 1)} ms per frame, at most ${fixed(most, 1)} ms; 3D drawing ${fixed(drawing, 1)} ms`;
  }

  private showLink(link: Link): void {
    this.link.textContent = {
      connecting: "connecting",
      open: "connected",
      lost: "not connected",
      refused: "refused",
    }[link.kind];
    this.link.dataset["kind"] = link.kind;
  }
}
