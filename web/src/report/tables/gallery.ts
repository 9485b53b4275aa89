// All maps as small pictures, each a link to its section: of all systems, or of all runs of a single
// one.

import { breakable, element, type Child } from "../../parts/dom";
import { labelsThumbnail } from "../../parts/maps/map_labels";
import { countOf, percent } from "../../parts/numbers";
import { addressOf } from "../page/address";
import type { Group } from "../page/groups";
import { lazy } from "../page/lazy";
import { mainResults } from "./main_results";
import { seedWords } from "../page/origin";
import { Selection } from "../page/selection";
import { winnersOf } from "../maps/system_map";
import type { SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

interface Card {
  selection: Selection;
  link: string;
  name: string;
  words: string;
}

/** Null if there is only one map. */
export function galleryOf(groups: readonly Group[]): Child {
  const systems = groups.flatMap((group) => group.systems).filter(({ system }) => system.grid !== null);
  const [first] = groups;
  if (systems.length > 1) {
    const cards = systems.map(({ system, link }) => ({
      selection: new Selection(system),
      link,
      name: systemName(system),
      words: accuracyWords(system),
    }));
    return gallery("All maps", cards);
  }
  return first ? galleryOfRuns(first) : null;
}

const kMostRuns = 24;

function galleryOfRuns({ id, systems: [only] }: Group): Child {
  const runs = only?.system.protocols[0]?.runs ?? [];
  if (!only?.system.grid || runs.length < 2) return null;
  const cards = runs.slice(0, kMostRuns).map((_, run): Card => {
    const selection = new Selection(only.system);
    selection.setRun(run);
    const state = { run: String(run + 1) };
    return { selection, link: addressOf(id, state), name: `Seed ${seedWords(selection)}`, words: "" };
  });
  const title = runs.length > kMostRuns ? `Maps of the first ${kMostRuns} of ${countOf(runs.length, "run")}` : "Maps of all runs";
  return gallery(title, cards);
}

function gallery(title: string, cards: readonly Card[]): HTMLElement {
  const items = cards.map((one) => element("li", {}, [cardOf(one)]));
  return element("div", { class: "gallery" }, [
    element("h2", { class: "gallery-title" }, [title]),
    element("ul", {}, items),
  ]);
}

function cardOf({ selection, link, name, words }: Card): HTMLElement {
  return element("a", { href: link }, [
    element("span", { class: "thumbnail" }, [lazy(0, () => [thumbnail(selection)])]),
    element("span", { class: "gallery-name" }, breakable(name)),
    words === "" ? null : element("span", { class: "muted" }, [words]),
  ]);
}

const kSize = 150;

function thumbnail({ system, grid, protocol, run, label }: Selection): Child {
  const winners = protocol && run ? winnersOf(system, protocol, run, label) : null;
  if (!grid || !winners) return null;
  return labelsThumbnail(grid, { ...winners, label: `Map of ${systemName(system)}`, size: kSize });
}

function accuracyWords(system: SystemReport): string {
  const { trained, known } = mainResults(system);
  const result = known ?? trained;
  if (!result) return "";
  return `${percent(result.accuracy.mean)} ${known ? "held out" : "training samples"}`;
}
