// The activities of a map that associations call up from other senses: beside its own, a second
// map that lights up.

import { sequenceColour } from "../../parts/maps/colour_maps";
import type { GraphData, ModuleData } from "../../parts/data";
import { element, fill } from "../../parts/dom";
import { type ValuesPicture, valuesPicture } from "../../parts/maps/map_picture";
import type { Frame, State } from "../data";

type MapState = State["maps"][number];

interface RecalledMap {
  name: string;
  picture: ValuesPicture;
  place: HTMLElement;
}

export class RecalledMaps {
  readonly root = element("div", { class: "map-recalled" });
  private maps: RecalledMap[] = [];

  constructor(private readonly onChoose: (map: string, neuron: number) => void) {}

  /** For another map, or another system. */
  build(map: MapState | null, graph: GraphData | null): void {
    const associations = map === null ? [] : (graph?.modules ?? []).filter((one) => callsUp(one, map.module));
    this.maps = associations.map((association) => this.recalled(association, map!));
    this.root.hidden = this.maps.length === 0;
    fill(
      this.root,
      this.maps.map(({ place }) => place),
    );
  }

  draw(frame: Frame | null): void {
    for (const { name, picture, place } of this.maps) {
      const values = frame?.modules[name]?.values.map((value) => value ?? 0) ?? [];
      const most = Math.max(0, ...values);
      const winner = most > 0 ? values.indexOf(most) : null;
      picture.setValues(values, [0, most || 1]);
      picture.setWinner(winner);
      place.dataset["winner"] = String(winner ?? "");
    }
  }

  private recalled(association: ModuleData, map: MapState): RecalledMap {
    const { name } = association;
    const from = inputOf(association, "input");
    const picture = valuesPicture(map.grid, {
      label: `Activity of the map ${map.module} that ${name} calls up from ${from}`,
      colour: sequenceColour,
      legend: false,
      onChoose: (neuron) => this.onChoose(map.module, neuron),
    });
    picture.setMarks(map.neuron_classes, map.classes);
    picture.element.querySelector("output")?.setAttribute("aria-live", "off"); // changes with every frame
    const title = element("p", { class: "small muted" }, [`called up by ${from}`]);
    const place = element("div", { class: "map-place", "data-recalled": name }, [picture.element, title]);
    return { name, picture, place };
  }
}

function inputOf({ inputs }: ModuleData, port: string): string {
  return inputs.find((input) => input.port === port)?.module ?? "";
}

function callsUp(module: ModuleData, map: string): boolean {
  return module.type === "association" && inputOf(module, "target") === map;
}
