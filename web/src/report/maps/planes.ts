// Component planes, projected onto the hand: on the left the component plane of one element, on the
// right the weights of one neuron for all elements. A selection on one side changes the other.

import { choice } from "../../parts/controls";
import type { ChannelPlanes, GridData } from "../../parts/data";
import { element, fill, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { neuronWords } from "../../parts/maps/grid";
import { handMap, type HandPicture } from "../../parts/hands/hand_map";
import { valuesPicture, type ValuesPicture } from "../../parts/maps/map_picture";
import { capital, rangeOf, readable, withUnit } from "../../parts/numbers";
import { allPlanesFigure } from "./all_planes";
import { fitting } from "../page/fitting";
import { axisOf } from "./frequencies";
import { linePicture } from "./line_picture";
import { shownOfSaved } from "../page/origin";
import { savedNotice } from "../page/saved_notice";
import type { Selection } from "../page/selection";
import { neuronTable } from "./system_map";
import type { SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

/** Names of files begin with `prefix`, so that the same planes may be on the page twice. */
export function planeFigures(selection: Selection, prefix = ""): Child[] {
  const { grid, trained } = selection.system;
  if (!grid || !trained) return [];
  const place = element("div", { class: "figures" });
  const notice = element("div");
  let linked: LinkedPlanes | null = null;
  const names = trained.planes.map((planes) => planes.channel.name);
  const show = (index: number) => {
    const planes = trained.planes[index];
    if (!planes) return;
    linked = new LinkedPlanes(selection, grid, planes, prefix);
    fill(place, linked.figures());
  };
  const redraw = () => fill(notice, [savedNotice(selection)]);
  redraw();
  selection.listen(redraw);
  selection.listenToNeuron((neuron) => linked?.follow(neuron));
  selection.listenToMarks(() => linked?.mark());
  const first = richest(trained.planes);
  show(first);
  const channels = names.length > 1 ? [choice("Channel", names, first, show).element] : [];
  return [notice, element("div", { class: "controls" }, channels), place];
}

/** The figures of all channels at once. */
export function allPlaneFigures(selection: Selection): Child[] {
  const { grid, trained } = selection.system;
  if (!grid || !trained) return [];
  return trained.planes.flatMap((planes) => new LinkedPlanes(selection, grid, planes, "").figures());
}

/** The plane with most elements comes first. */
function richest(all: ChannelPlanes[]): number {
  const counts = all.map((planes) => planes.channel.elements.length);
  return Math.max(0, counts.indexOf(Math.max(...counts)));
}

const kMapSize = 420;

class LinkedPlanes {
  private readonly system: SystemReport;
  private element = 0;
  private neuron = 0;
  private readonly map: ValuesPicture;
  private readonly hand: HandPicture;
  private readonly elements;
  private readonly names: readonly string[]; // of the elements
  private readonly mapTitle = element("p", { class: "small what" });
  private readonly handTitle = element("p", { class: "small what" });

  constructor(
    private readonly selection: Selection,
    private readonly grid: GridData,
    private readonly planes: ChannelPlanes,
    private readonly prefix: string,
  ) {
    this.system = selection.system;
    const { channel, unit } = planes;
    this.neuron = (selection.isOfSavedMap ? selection.neuron : null) ?? busiest(planes);
    this.element = strongest(planes.values[this.neuron] ?? []);
    const mapLabel = `Component plane of ${channel.name}`;
    const keep = {
      onChoose: (neuron: number) => this.chooseNeuron(neuron),
      onPoint: (neuron: number | null) => this.preview(neuron),
    };
    this.map = valuesPicture(grid, { label: mapLabel, unit, size: fitting(kMapSize), ...keep });
    const handLabel = `Weights of a neuron for ${channel.name}`;
    const keepElement = {
      onChoose: (one: number) => this.setElement(one),
      onPoint: (one: number | null) => this.previewPlane(one),
    };
    const options = { label: handLabel, unit, size: fitting(380), ...keepElement };
    const axis = axisOf(this.system, channel);
    this.names = axis?.unit ? axis.values.map((value) => withUnit(readable(value), axis.unit)) : channel.elements;
    this.hand = axis ? linePicture(axis, options) : handMap(channel, options);
    this.elements = choice("Element", this.names, this.element, (one) => this.setElement(one));
    this.setElement(this.element);
    this.setNeuron(this.neuron);
  }

  figures(): Child[] {
    const { channel } = this.planes;
    const name = `${this.prefix}${systemName(this.system)}-${channel.name}`;
    const isOne = channel.elements.length === 1;
    const figures: Child[] = [
      figure({
        title: isOne ? `Component plane of ${channel.name}` : `Component plane of an element of ${channel.name}`,
        file: `${name}-plane`,
        controls: isOne ? [] : [this.elements.element],
        body: element("div", {}, [this.mapTitle, this.map.element]),
        picture: () => this.map.svg,
        numbers: () =>
          neuronTable(this.grid, this.planes.channel.elements, (i) => this.planes.values[i] ?? []),
        about: () => shownOfSaved(this.system),
        hint: isOne ? "" : "Select a neuron to see its weights. The CSV contains the planes of all elements.",
      }),
      figure({
        title: this.hand.isHand ? "Weights of one neuron on the hand" : "Weights of one neuron",
        file: `${name}-neuron`,
        body: element("div", {}, [this.handTitle, this.hand.element]),
        picture: () => this.hand.svg,
        numbers: () => this.neuronNumbers(),
        about: () => this.shownNeuron(),
        hint: "Select an element to see its component plane.",
      }),
    ];
    if (isOne) return figures.slice(0, 1);
    const all = allPlanesFigure(this.grid, this.planes, rangeOfAll(this.planes), name, (one) =>
      this.setElement(one),
      shownOfSaved(this.system),
    );
    return [...figures, all];
  }

  /** Shows the neuron that was selected in another figure of the same map. */
  follow(neuron: number | null): void {
    if (neuron !== null && neuron !== this.neuron && this.selection.isOfSavedMap) this.setNeuron(neuron);
  }

  /** Marks the neurons that correspond to a selection on another map. */
  mark(): void {
    this.map.mark(this.selection.isOfSavedMap ? this.selection.marks : []);
  }

  private chooseNeuron(neuron: number): void {
    this.setNeuron(neuron);
    if (this.selection.isOfSavedMap) this.selection.setNeuron(neuron);
  }

  private setElement(one: number): void {
    this.element = one;
    this.elements.set(one);
    this.hand.select(one);
    this.previewPlane(null);
  }

  private setNeuron(neuron: number): void {
    this.neuron = neuron;
    this.map.select(neuron);
    this.preview(null);
  }

  /** The plane of the element under the pointer, or of the selected one. */
  private previewPlane(pointed: number | null): void {
    const one = pointed ?? this.element;
    this.map.setValues(this.planes.values.map((values) => values[one] ?? null));
    this.mapTitle.textContent = this.names.length > 1 ? (this.names[one] ?? "") : "";
  }

  private preview(pointed: number | null): void {
    const neuron = pointed ?? this.neuron;
    this.hand.setValues(this.planes.values[neuron] ?? [], rangeOfAll(this.planes));
    this.handTitle.textContent = capital(neuronWords(this.grid, neuron));
  }

  private shownNeuron() {
    const shown = shownOfSaved(this.system);
    return { ...shown, words: `${shown.words}, ${neuronWords(this.grid, this.neuron)}`, name: `${shown.name}-neuron${this.neuron + 1}` };
  }

  private neuronNumbers() {
    const values = this.planes.values[this.neuron] ?? [];
    const columns = ["element", `weight of ${neuronWords(this.grid, this.neuron).replace(",", "")}`];
    return { columns, rows: this.planes.channel.elements.map((name, i) => [name, values[i] ?? null]) };
  }
}

const ranges = new WeakMap<ChannelPlanes, [number, number]>();

/** The range is the same for all neurons, so that they can be compared. */
function rangeOfAll(planes: ChannelPlanes): [number, number] {
  const known = ranges.get(planes);
  if (known) return known;
  const ends = planes.values.map((values) => rangeOf(values)).filter((range) => range !== null);
  const range: [number, number] =
    ends.length === 0
      ? [0, 1]
      : [Math.min(...ends.map(([low]) => low)), Math.max(...ends.map(([, high]) => high))];
  ranges.set(planes, range);
  return range;
}

/** The neuron with the largest weight, as the initial selection. */
function busiest(planes: ChannelPlanes): number {
  const peaks = planes.values.map((values) => rangeOf(values)?.[1] ?? Number.NEGATIVE_INFINITY);
  return Math.max(0, peaks.indexOf(Math.max(...peaks)));
}

function strongest(values: (number | null)[]): number {
  const high = rangeOf(values)?.[1];
  return high === undefined ? 0 : Math.max(0, values.indexOf(high));
}
