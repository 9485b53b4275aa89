// One channel over time: lines, a band for each of many elements, or the waveform of a sound.

import uPlot from "uplot";

import type { ChannelData, NumberOrNull } from "../../parts/data";
import { element, fill } from "../../parts/dom";
import type { Model } from "../session/model";
import { timeEnd } from "./strip_axes";
import { bandPlot } from "./strip_band";
import { linePlot } from "./strip_lines";
import { wavePlot } from "./strip_wave";
import { StripValues } from "./strip_values";

type Kind = "lines" | "bands" | "wave";

/** Missing in its types: changes made inside are drawn at its end, not later. */
interface Batching extends uPlot {
  batch(run: (plot: uPlot) => void): void;
}

const kMostLines = 12;
const kHeight = 60; // before its place is known

export class Strip {
  readonly root: HTMLElement;
  private readonly place = element("div", { class: "strip-plot" });
  private readonly values: StripValues;
  private plot: Batching | null = null;
  private data: (() => uPlot.AlignedData) | null = null;
  private kind: Kind | null = null;
  private element: number | null = null; // under the pointer
  private drawn = ""; // of the history, over that time
  private readonly unwatch: () => void;
  private readonly observer = new ResizeObserver(() => this.resize());

  constructor(
    private readonly channel: ChannelData,
    private readonly model: Model,
  ) {
    this.values = new StripValues(channel);
    const unit = channel.unit === "" ? null : element("span", { class: "muted" }, [channel.unit]);
    const title = element("h3", {}, [channel.name, " ", unit]);
    const head = element("div", { class: "strip-head" }, [title, this.values.root]);
    this.root = element("div", { class: "strip", "data-channel": channel.name }, [head, this.place]);
    this.place.setAttribute("role", "img");
    this.place.setAttribute(
      "aria-label",
      `${channel.name} over time${channel.unit && `, in ${channel.unit}`}`,
    );
    this.observer.observe(this.place);
    this.unwatch = model.pointed.watch(() => this.showValues());
  }

  draw(): void {
    const values = this.model.frame.value?.channels[this.channel.name] ?? null;
    this.showValues();
    if (values === null && this.plot === null) return;
    this.make(this.kindOf(values));
    this.plot?.batch((plot: uPlot) => this.bring(plot));
  }

  /** Shows the values of the moment under the pointer, or of the present one. */
  private showValues(): void {
    const { frame, history, pointed } = this.model;
    const { name } = this.channel;
    const past = pointed.value === null ? null : history.at(pointed.value.time, name);
    if (past === null) return this.values.show(frame.value?.channels[name] ?? null);
    const own = this.element === null ? null : Math.min(past.length - 1, Math.max(0, this.element));
    this.values.show(past, { time: pointed.value!.time, element: own });
  }

  /** Unchanged data are not computed again. Inside a batch, so that it is drawn immediately. */
  private bring(plot: uPlot): void {
    const { version, isWhole } = this.model.history;
    const wanted = [version, timeEnd(this.model)].join();
    if (this.kind !== "wave" && wanted === this.drawn) return plot.redraw(false);
    this.drawn = wanted;
    if (this.data !== null) plot.setData(this.data());
    this.root.dataset["whole"] = String(isWhole);
  }

  destroy(): void {
    this.unwatch();
    this.observer.disconnect();
    this.plot?.destroy();
  }

  private kindOf(values: readonly NumberOrNull[] | null): Kind {
    if (values === null) return this.kind ?? "lines";
    if (values.length > this.channel.elements.length) return "wave";
    return this.channel.elements.length > kMostLines ? "bands" : "lines";
  }

  private make(kind: Kind): void {
    if (kind === this.kind) return;
    this.kind = kind;
    this.drawn = "";
    this.plot?.destroy();
    fill(this.place, []);
    const make = { lines: linePlot, bands: bandPlot, wave: wavePlot }[kind];
    const { options, data } = make(this.channel, this.model);
    const size = { width: this.place.clientWidth || 300, height: this.place.clientHeight || kHeight };
    this.data = data;
    this.plot = new uPlot(
      { ...size, legend: { show: false }, padding: [5, 6, 0, 0], series: [], ...options },
      data(),
      this.place,
    ) as Batching;
    this.seekOnClick(kind);
    this.pointAt(kind);
  }

  private pointAt(kind: Kind): void {
    const plot = this.plot;
    if (plot === null || kind === "wave") return;
    plot.over.addEventListener("pointermove", (event) => {
      const box = plot.over.getBoundingClientRect();
      const row = plot.posToVal(event.clientY - box.top, "y");
      this.element = kind === "bands" ? Math.round(row) - 1 : null;
      this.model.pointed.set({ time: plot.posToVal(event.clientX - box.left, "x") });
    });
    plot.over.addEventListener("pointerleave", () => {
      this.element = null;
      this.model.pointed.set(null);
    });
  }

  /** A click seeks to that moment. */
  private seekOnClick(kind: Kind): void {
    const plot = this.plot;
    if (plot === null || kind === "wave") return;
    plot.over.addEventListener("click", (event) => {
      const box = plot.over.getBoundingClientRect();
      this.seek(plot.posToVal(event.clientX - box.left, "x"));
    });
  }

  private seek(time: number): void {
    const { exploration, frames, duration } = this.model.shownState.value ?? {};
    if (exploration === null || exploration === undefined || !frames || !duration) return;
    const frame = Math.round((time / duration) * (frames - 1));
    void this.model.send({ command: "seek", exploration, frame: Math.min(frames - 1, Math.max(0, frame)) });
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (width > 0 && height > 0) this.plot?.setSize({ width, height });
  }
}
