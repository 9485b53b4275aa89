// The input weights of a T-MPSOM: those of all neurons, and the receptive field of one neuron.

import * as Plot from "@observablehq/plot";

import { choice } from "../../parts/controls";
import { element, fill, uniqueId, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import type { ReceptiveFields, SystemReport } from "../page/unpacked";
import { matrixPicture, type MatrixPicture } from "./matrix";
import { plotFigure, plotPicture } from "./plots";
import { shownOfSaved } from "../page/origin";
import { systemName } from "../page/words";

export function connectivityFigures(system: SystemReport): Child[] {
  const all = system.trained?.receptive_fields ?? [];
  const place = element("div", { class: "figures" });
  const show = (index: number) => {
    const fields = all[index];
    if (fields) fill(place, new Fields(system, fields).figures());
  };
  show(0);
  const names = all.map((fields) => `${fields.module} from ${fields.input}`);
  const modules = choice("Connections", names, 0, show).element;
  return [element("div", { class: "controls" }, [modules]), place];
}

/** The figures of all connections at once. */
export function allConnectivityFigures(system: SystemReport): Child[] {
  return (system.trained?.receptive_fields ?? []).flatMap((fields) => new Fields(system, fields).figures());
}

class Fields {
  private row = 0;
  private readonly matrix: MatrixPicture;
  private readonly plot = element("div");
  private readonly slider: HTMLInputElement;
  private readonly title = element("p", { class: "small what" });
  private readonly sliderPlace: HTMLElement;

  constructor(
    private readonly system: SystemReport,
    private readonly fields: ReceptiveFields,
  ) {
    const last = Math.max(0, fields.neurons.length - 1);
    this.matrix = matrixPicture(fields.weights, {
      label: `Weights of ${fields.module} from ${fields.input}`,
      rowName: "neuron",
      columnName: `element of ${fields.input}`,
      unit: "weight",
      rowEnds: [String((fields.neurons[0] ?? 0) + 1), String((fields.neurons[last] ?? 0) + 1)],
      columnEnds: ["1", String(fields.elements)],
      describe: (row, column) => `neuron ${(fields.neurons[row] ?? 0) + 1}, element ${column + 1}`,
      onRow: (row) => this.setRow(row),
    });
    const id = uniqueId("neuron");
    this.slider = element("input", { type: "range", id, min: 0, max: last, step: 1 });
    this.slider.addEventListener("input", () => this.setRow(Number(this.slider.value)));
    this.sliderPlace = element("span", { class: "control" }, [
      element("label", { for: id }, ["Neuron"]),
      this.slider,
    ]);
    this.setRow(Math.floor(last / 2));
  }

  figures(): Child[] {
    const { fields } = this;
    const [rows, columns] = fields.shape;
    const name = `${systemName(this.system)}-${fields.module}-${fields.input}`;
    const some = fields.neurons.length < rows * columns ? `, ${fields.neurons.length} of them` : "";
    return [
      figure({
        title: `Weights of ${fields.module} for ${fields.input}`,
        file: `${name}-connectivity`,
        body: this.matrix.element,
        picture: () => this.matrix.svg,
        about: () => shownOfSaved(this.system),
        numbers: () => ({
          columns: ["neuron", ...elementNames(fields)],
          rows: fields.weights.map((weights, i) => [(fields.neurons[i] ?? 0) + 1, ...weights]),
        }),
        note: `Each row is one of the ${rows} × ${columns} neurons${some}; ${fields.input} is spread along ${fields.axis === 0 ? "the rows" : "the columns"} of neurons.`,
      }),
      figure({
        title: "Receptive field",
        file: `${name}-receptive-field`,
        controls: [this.sliderPlace],
        body: element("div", {}, [this.title, this.plot]),
        picture: () => plotPicture(this.plot, []),
        about: () => shownOfSaved(this.system),
        numbers: () => ({
          columns: ["element", "weight"],
          rows: (fields.weights[this.row] ?? []).map((weight, i) => [i + 1, weight]),
        }),
        note: "The weights of one neuron along its input.",
      }),
    ];
  }

  private setRow(row: number): void {
    this.row = row;
    const number = this.fields.neurons[row] ?? 0;
    const columns = this.fields.shape[1];
    const words = `Neuron ${number + 1}: row ${Math.floor(number / columns) + 1}, column ${(number % columns) + 1}`;
    this.slider.value = String(row);
    this.slider.setAttribute("aria-valuetext", words);
    this.title.textContent = words;
    this.matrix.markRow(row);
    fill(this.plot, [fieldPlot(this.fields, row)]);
  }
}

function elementNames(fields: ReceptiveFields): string[] {
  return Array.from({ length: fields.elements }, (_, i) => `element ${i + 1}`);
}

function fieldPlot(fields: ReceptiveFields, row: number): HTMLElement {
  const points = (fields.weights[row] ?? []).map((weight, i) => ({ x: i + 1, weight: weight ?? 0 }));
  return plotFigure(`Receptive field over ${fields.input}`, {
    height: 260,
    x: { label: `element of ${fields.input}`, grid: false, domain: [0.5, fields.elements + 0.5] },
    y: { label: "weight", grid: true, nice: true },
    marks: [
      Plot.areaY(points, { x: "x", y: "weight", fill: "var(--class-0)", fillOpacity: 0.18, curve: "step" }),
      Plot.lineY(points, { x: "x", y: "weight", stroke: "var(--class-0)", strokeWidth: 1.5, curve: "step" }),
      Plot.ruleY([0], { stroke: "var(--line-strong)" }),
    ],
  });
}
