// The skin coloured by contributions: how much each sensor separates the class that is read from the
// next one.

import type { ChannelData } from "../../parts/data";
import { element, fill, write } from "../../parts/dom";
import {
  coloursInWords,
  contributionPicture,
  greatestOf,
  signed,
  strongestOf,
  type ContributionPicture,
} from "../../parts/hands/contributions";
import type { Reading, State } from "../data";
import type { Model } from "../session/model";

type Given = NonNullable<Reading["contributions"]>;

const kSize = 300;
const kMostPitch = 75;
const kMostListed = 2; // which fit below the skin

export class Contributions {
  readonly root = element("div", { class: "contributions" });
  private readonly place = element("div", { class: "skin-place" });
  private readonly legend = element("p", { class: "small" });
  private readonly list = element("ol", { class: "small", "aria-label": "Greatest contributions" });
  private channels: readonly ChannelData[] = [];
  private pictures: { name: string; picture: ContributionPicture }[] = [];

  constructor(private readonly model: Model) {
    this.root.append(this.place, this.legend, this.list);
  }

  build(channels: readonly ChannelData[]): void {
    this.channels = channels;
    this.hide();
  }

  hide(): void {
    this.root.hidden = true;
    this.pictures = [];
    fill(this.place, []);
  }

  private draw(): void {
    this.pictures = this.channels.map((channel) => ({ name: channel.name, picture: pictureOf(channel) }));
    fill(
      this.place,
      this.pictures.map(({ picture }) => picture.element),
    );
  }

  show(reading: Reading | null): void {
    this.root.hidden = false;
    if (this.pictures.length === 0) this.draw();
    const given = reading?.contributions ?? null;
    this.place.hidden = this.list.hidden = given === null;
    if (reading === null || given === null) {
      write(this.legend, "There is no reading of two classes.");
      return;
    }
    const end = greatestOf(Object.values(given.channels));
    for (const { name, picture } of this.pictures) {
      picture.element.hidden = given.channels[name] === undefined;
      picture.show(given.channels[name] ?? [], end);
    }
    write(this.legend, coloursInWords(reading.candidates[0]?.name ?? reading.answer, given.other));
    this.listGreatest(given);
  }

  private listGreatest(given: Given): void {
    const words = strongest(given, this.model.shownState.value);
    const items = [...this.list.children];
    if (items.length !== words.length) {
      fill(
        this.list,
        words.map((one) => element("li", {}, [one])),
      );
      return;
    }
    items.forEach((item, i) => write(item as HTMLElement, words[i]!));
  }
}

function pictureOf(channel: ChannelData): ContributionPicture {
  const picture = contributionPicture(channel, { size: kSize, mostPitch: kMostPitch, palm: true });
  picture.element.querySelector("output")?.setAttribute("aria-live", "off"); // changes with every frame
  return picture;
}

function strongest(given: Given, state: State | null): string[] {
  const all = Object.entries(given.channels).map(([name, values]) => {
    const elements = state?.channels.find((channel) => channel.name === name)?.elements ?? [];
    return { name, elements, values };
  });
  return strongestOf(all, kMostListed).map(
    ({ name, element: one, value }) => `${name} ${one}: ${signed(value, given.unit)}`,
  );
}

/** Whether the skin is coloured by contributions instead of readings. */
export function contributionsSwitch(model: Model): HTMLElement {
  const box = element("input", { type: "checkbox" });
  box.addEventListener("change", () => model.explains.set(box.checked));
  model.explains.watch((on) => (box.checked = on));
  const title = "Colour the sensors by how much they separate the class that is read from the next one; the contributions sum to the difference of the two distances";
  return element("label", { class: "hold", title }, [box, "contributions"]);
}
