// Reports a lost connection and the time of the next attempt, with a button to try now.

import { element } from "../../parts/dom";
import type { Link } from "../session/connection";
import type { Model } from "../session/model";
import { Speaker } from "./speaker";

const kLost = "The program has ended or the connection is lost";
const kFull = "Too many viewers are connected";
const kRefused =
  "Access refused: the token of this page is missing or belongs to an earlier run. Open the address printed by somato view.";

export class LinkBanner {
  readonly root: HTMLElement;
  private readonly words = element("p");
  private readonly button: HTMLButtonElement;
  private readonly speaker = new Speaker("link-spoken");

  constructor(model: Model, tryNow: () => void) {
    this.button = element("button", { type: "button", class: "primary", onclick: tryNow }, ["Try now"]);
    const banner = element("div", { class: "link-banner" }, [this.words, this.button]);
    this.root = element("div", { class: "link-place" }, [banner, this.speaker.root]);
    model.shownLink.watch((link) => {
      banner.hidden = link.kind === "open" || (link.kind === "connecting" && model.shownState.value === null);
      this.show(link);
    });
  }

  private show(link: Link): void {
    this.button.disabled = link.kind === "connecting";
    this.words.textContent = wordsOf(link);
    const spoken = { lost: `${kLost}; trying again`, refused: kRefused, open: "Connected", connecting: "" }[
      link.kind
    ];
    if (spoken !== "") this.speaker.say(link.kind, spoken);
  }
}

function wordsOf(link: Link): string {
  if (link.kind === "lost") return `${link.full ? kFull : kLost}; trying again in ${link.seconds} s`;
  if (link.kind === "connecting") return `${kLost}; trying again now`;
  return link.kind === "refused" ? kRefused : "";
}
