// Plots by Observable Plot, in the style of the page.

import * as Plot from "@observablehq/plot";

import { classColour, kClassColours } from "../../parts/maps/colour_maps";
import { element } from "../../parts/dom";
import { marker } from "../../parts/maps/markers";
import { markerLegend } from "../../parts/maps/legend";
import { sizeOf } from "../../parts/save";
import { shape, svg } from "../../parts/svg";

/** The plot in an element that it fills. */
export function plotFigure(label: string, options: Plot.PlotOptions): HTMLElement {
  const made = Plot.plot({
    width: 460,
    marginLeft: 48,
    marginBottom: 38,
    ...options,
    style: { background: "none", fontSize: "12px", fontFamily: "inherit", overflow: "hidden" },
  });
  made.setAttribute("role", "img");
  made.setAttribute("aria-label", label);
  // Plot labels axes and marks inside a picture, where the labels are of no use to screen readers.
  made.querySelectorAll("[aria-label]").forEach((part) => part.removeAttribute("aria-label"));
  made.classList.add("plot");
  return element("div", { class: "plot-place" }, [made]);
}

/** Line colours of a plot follow the theme. */
export function strokeOf(line: number): string {
  return classColour(line % kClassColours);
}

/** The plot as a picture to save, including its legend. */
export function plotPicture(place: HTMLElement, names: readonly string[]): SVGSVGElement | null {
  const plot = place.querySelector<SVGSVGElement>("svg.plot");
  if (!plot || names.length < 2) return plot;
  const [, , width = 0, height = 0] = sizeOf(plot);
  const legend = markerLegend(width, names);
  const copy = plot.cloneNode(true) as SVGSVGElement;
  for (const [name, value] of Object.entries({ y: legend.height + 10, width, height }))
    copy.setAttribute(name, String(value));
  return svg(width, height + legend.height + 10, plot.getAttribute("aria-label") ?? "", [legend.group, copy]);
}

export function seriesLegend(names: readonly string[]): HTMLElement {
  const entries = names.map((name, i) => {
    const sign = shape("svg", { width: 16, height: 16, viewBox: "0 0 16 16", "aria-hidden": "true" }, [
      marker(i, 8, 8, 4.5),
    ]);
    return element("li", {}, [sign, name]);
  });
  return element("ul", { class: "series-legend" }, entries);
}
