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
import { firstMap, foldAccuracies, foldCount, foldMap, shownMap, winnersOn, type ShownMap } from "../maps/shown_map";
import type { ProtocolData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

interface Card {
  selection: Selection;
  map: ShownMap | null;
  link: string;
  name: string;
  words: string;
}

/** Null if there is only one map. */
export function galleryOf(groups: readonly Group[]): Child {
  const systems = groups.flatMap((group) => group.systems).filter(({ system }) => system.grid !== null);
  const [first] = groups;
  if (systems.length > 1) {
    const cards = systems.map(({ system, link }) => {
      const selection = new Selection(system);
      return { selection, map: firstMap(selection), link, name: systemName(system), words: accuracyWords(system) };
    });
    return gallery("All maps", cards);
  }
  return first ? galleryOfRuns(first) : null;
}

const kMostRuns = 24;

function galleryOfRuns({ id, systems: [only] }: Group): Child {
  const protocol = only?.system.protocols[0];
  if (!only?.system.grid || !protocol) return null;
  const cards = foldCount(protocol) > 0 ? cardsOfFolds(id, only.system, protocol) : cardsOfRuns(id, only.system, protocol);
  if (cards.length < 2) return null;
  const unit = foldCount(protocol) > 0 ? "fold" : "run";
  const title = cards.length > kMostRuns ? `Maps of the first ${kMostRuns} of ${countOf(cards.length, unit)}` : `Maps of all ${unit}s`;
  return gallery(title, cards.slice(0, kMostRuns));
}

function cardsOfRuns(id: string, system: SystemReport, { runs }: ProtocolData): Card[] {
  return runs.flatMap((_, run): Card[] => {
    const selection = new Selection(system);
    selection.setRun(run);
    const map = shownMap(selection);
    const link = addressOf(id, { run: String(run + 1) });
    return map?.kind === "run" ? [{ selection, map, link, name: `Seed ${seedWords(selection)}`, words: "" }] : [];
  });
}

/** A map for each training of each run. */
function cardsOfFolds(id: string, system: SystemReport, protocol: ProtocolData): Card[] {
  return protocol.runs.flatMap((one, run) =>
    foldAccuracies(protocol, one).flatMap((accuracy, fold): Card[] => {
      const selection = new Selection(system);
      selection.setRun(run);
      selection.setFold(fold);
      const map = foldMap(selection, fold);
      const link = addressOf(id, { run: String(run + 1), fold: String(fold + 1) });
      const name = `Seed ${seedWords(selection)}, fold ${fold + 1}`;
      return map ? [{ selection, map, link, name, words: percent(accuracy) }] : [];
    }),
  );
}

function gallery(title: string, cards: readonly Card[]): HTMLElement {
  const items = cards.map((one) => element("li", {}, [cardOf(one)]));
  return element("div", { class: "gallery" }, [
    element("h2", { class: "gallery-title" }, [title]),
    element("ul", {}, items),
  ]);
}

function cardOf({ selection, map, link, name, words }: Card): HTMLElement {
  return element("a", { href: link }, [
    element("span", { class: "thumbnail" }, [lazy(0, () => [thumbnail(selection, map)])]),
    element("span", { class: "gallery-name" }, breakable(name)),
    words === "" ? null : element("span", { class: "muted" }, [words]),
  ]);
}

const kSize = 150;

function thumbnail(selection: Selection, map: ShownMap | null): Child {
  const winners = map && winnersOn(map, selection);
  if (!map || !winners) return null;
  return labelsThumbnail(map.grid, { ...winners, label: `Map of ${systemName(selection.system)}`, size: kSize });
}

function accuracyWords(system: SystemReport): string {
  const { trained, known } = mainResults(system);
  const result = known ?? trained;
  if (!result) return "";
  return `${percent(result.accuracy.mean)} ${known ? "held out" : "training samples"}`;
}
