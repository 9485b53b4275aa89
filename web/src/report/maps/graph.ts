// The figure of a system's modules, with the settings of the selected one.

import type { ModuleData } from "../../parts/data";
import { element, fill, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { graphPicture } from "../../parts/graph_picture";
import type { SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

export function graphFigure(system: SystemReport): Child {
  const { graph } = system;
  if (!graph) return null;
  const details = element("div", { class: "module-details", "aria-live": "polite" }, [
    element("p", { class: "small muted no-print" }, ["Select a module to see its settings."]),
  ]);
  const picture = graphPicture(graph, (module) => {
    picture.select(module.name);
    fill(details, moduleDetails(module));
  });
  const place = element("div", { class: "graph", role: "group", "aria-label": "Modules", tabindex: 0 }, [
    picture.svg,
  ]);
  return figure({
    title: "Modules",
    file: `${systemName(system)}-modules`,
    body: element("div", {}, [place, details]),
    picture: () => picture.svg,
    numbers: () => ({
      columns: ["module", "type", "inputs", "shape", "rate", "learns", "parameters"],
      rows: graph.modules.map((module) => [
        module.name,
        module.type,
        module.inputs.map((one) => one.module).join(" "),
        module.shape.join(" x "),
        module.rate,
        module.learns ? "yes" : "no",
        parameterWords(module),
      ]),
    }),
    note: phaseNote(system),
    wide: true,
  });
}

function phaseNote(system: SystemReport): string {
  const phases = (system.graph?.phases ?? []).map(({ learn, draws, of }, i) => {
    const count = draws === null ? "" : ` from ${draws} ${of}`;
    return `${i + 1}: ${learn.join(", ")}${count}`;
  });
  if (phases.length === 0) return "";
  return phases.length === 1
    ? `The system is trained in one phase: ${phases[0]?.slice(3) ?? ""}.`
    : `The system is trained in phases: ${phases.join("; ")}.`;
}

function moduleDetails(module: ModuleData): Child[] {
  const rows = Object.entries(module.parameters).map(([name, value]) =>
    element("tr", {}, [
      element("th", { scope: "row" }, [element("code", {}, [name])]),
      element("td", {}, [element("code", {}, [value])]),
      element("td", { class: "muted" }, [module.not_given.includes(name) ? "not given in the paper" : ""]),
    ]),
  );
  const table = rows.length === 0 ? null : element("table", {}, [element("tbody", {}, rows)]);
  const words = `${module.text} ${module.inputs.length === 0 ? "" : `Inputs: ${module.inputs.map((one) => one.module).join(", ")}.`}`;
  return [
    element("p", { class: "figure-title" }, [module.name]),
    element("p", { class: "small muted" }, [words]),
    table,
  ];
}

function parameterWords(module: ModuleData): string {
  return Object.entries(module.parameters)
    .map(([name, value]) => `${name} = ${value}`)
    .join("; ");
}
