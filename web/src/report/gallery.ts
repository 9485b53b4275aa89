// All maps as small pictures, each a link to its section.

import { breakable, element, type Child } from "../parts/dom";
import { labelsThumbnail } from "../parts/map_labels";
import { percent } from "../parts/numbers";
import type { Numbered } from "./groups";
import { lazy } from "./lazy";
import { mainResults } from "./main_results";
import { Selection } from "./selection";
import { winnersOf } from "./system_map";
import type { SystemReport } from "./unpacked";
import { systemName } from "./words";

export function galleryOf(systems: readonly Numbered[]): HTMLElement {
  const cards = systems.map((one) => element("li", {}, [card(one)]));
  return element("div", { class: "gallery" }, [
    element("h2", { class: "gallery-title" }, ["All maps"]),
    element("ul", {}, cards),
  ]);
}

function card({ system, link }: Numbered): HTMLElement {
  return element("a", { href: link }, [
    element("span", { class: "thumbnail" }, [lazy(0, () => [thumbnail(system)])]),
    element("span", { class: "gallery-name" }, breakable(systemName(system))),
    element("span", { class: "muted" }, [accuracyWords(system)]),
  ]);
}

const kSize = 150;

function thumbnail(system: SystemReport): Child {
  const { protocol, run, label } = new Selection(system);
  const winners = protocol && run ? winnersOf(system, protocol, run, label) : null;
  if (!system.grid || !winners) return null;
  return labelsThumbnail(system.grid, { ...winners, label: `Map of ${systemName(system)}`, size: kSize });
}

function accuracyWords(system: SystemReport): string {
  const { trained, known } = mainResults(system);
  const result = known ?? trained;
  if (!result) return "";
  return `${percent(result.accuracy.mean)} ${known ? "held out" : "training samples"}`;
}
