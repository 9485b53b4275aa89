// The first screen: what came out in one sentence, the best map beside the hand and its objects,
// all maps, and the table of systems.

import { element, fill, type Child } from "../../parts/dom";
import { handLayout } from "../../parts/hands/hand_layout";
import { handMap } from "../../parts/hands/hand_map";
import { labelsPicture } from "../../parts/maps/map_labels";
import { capital, countOf } from "../../parts/numbers";
import { figure } from "../../parts/figure";
import { commonScale, hasPicture, thingPicture } from "../../parts/hands/thing_picture";
import { fitting } from "./fitting";
import { galleryOf } from "../tables/gallery";
import { groupsOf, questionsOf } from "./groups";
import { bestSystem, isOfHand, originals, summaryOf } from "../tables/main_results";
import { shownOfMap } from "./origin";
import { readingColours } from "../moments/reading_colours";
import { Selection } from "./selection";
import { firstMap, winnersOn } from "../maps/shown_map";
import { nextSteps } from "./next_steps";
import { systemsFigure } from "../tables/systems_table";
import type { MomentChannel, ReportData, SystemReport } from "./unpacked";
import { systemName } from "./words";

export function overviewSection(data: ReportData): HTMLElement {
  const groups = groupsOf(data);
  const best = bestSystem(originals(data));
  const standing = groups.flatMap(({ systems }) => systems);
  const inferences = data.inferences ?? [];
  return element("section", { id: "overview", class: "overview", "aria-label": "Overview" }, [
    element("header", { class: "title" }, [
      element("h1", {}, [titleOf(data)]),
      element("p", { class: "summary" }, [summaryOf(originals(data))]),
    ]),
    data.systems.length === 0 && inferences.length === 0
      ? element("p", { class: "message" }, [
          "No results were given. Name one or more results.json: somato report RESULTS.json -o report.html",
        ])
      : null,
    ...(best ? opening(best, galleryOf(groups), originals(data).length === 1 ? nextSteps(best) : null) : []),
    standing.length > 0 ? systemsFigure(standing, data, "systems") : null,
  ]);
}

export function titleOf(data: ReportData): string {
  const groups = groupsOf(data);
  const questions = questionsOf(data);
  const inferences = data.inferences ?? [];
  const [first] = groups;
  if (groups.length === 1 && first && questions.length + inferences.length === 0) return first.name;
  if (groups.length + inferences.length === 0 && questions.length === 1) return questions[0]?.name ?? "";
  const counts = [
    ...(groups.length > 0 ? [countOf(groups.length, "system")] : []),
    ...(questions.length > 0 ? [countOf(questions.length, "question")] : []),
    ...(inferences.length > 0 ? [countOf(inferences.length, "inference")] : []),
  ];
  return counts.length === 0 ? "Results" : `Results of ${counts.join(" and ")}`;
}

/** The steps are beside the map, or below it where the hand is beside the map. */
function opening(best: SystemReport, gallery: Child, steps: Child): Child[] {
  const hasHand = isOfHand(best);
  const hero = element("div", { class: hasHand ? "hero" : "hero without-hand" }, [
    bestMap(best),
    element("div", { class: "hero-body" }, [handOf(best), thingsOf(best), hasHand ? null : steps]),
    gallery,
  ]);
  return [hero, hasHand ? steps : null];
}

const kMapSize = 384;

function bestMap(system: SystemReport): Child {
  const selection = new Selection(system);
  const map = firstMap(selection);
  const winners = map && winnersOn(map, selection);
  if (!map || !winners) return null;
  const shown = shownOfMap(map, selection);
  const picture = labelsPicture(map.grid, { ...winners, label: `Map of ${systemName(system)}`, size: fitting(kMapSize) });
  return figure({
    title: `Map of ${systemName(system)}`,
    file: "overview-map",
    body: picture.element,
    picture: () => picture.svg,
    numbers: () => ({
      columns: ["sample", "winner", "class"],
      rows: winners.winners.map((winner, i) => [(map.samples[i] ?? 0) + 1, winner + 1, winners.names[winners.classes[i] ?? 0] ?? ""]),
    }),
    about: () => shown,
    note: `${shown.words}. Each marker is a sample at the neuron that wins it.`,
  });
}

/** The exploration with the greatest contact, at the moment of it; null without elements on a hand. */
function handOf(system: SystemReport): Child {
  const onHand = (one: MomentChannel) => handLayout(one.channel.elements) !== null;
  const moments = system.moments.filter((one) => one !== null);
  const shown = moments.flatMap((moment) => {
    const all = moment.channels.filter(onHand);
    const of = all.find(({ channel }) => channel.name === "touch") ?? all[0];
    return of ? [{ moment, of, contact: of.values.reduce((sum: number, value) => sum + (value ?? 0), 0) }] : [];
  });
  const [first] = shown.sort((one, other) => other.contact - one.contact);
  if (!first) return null;
  const { moment, of } = first;
  const name = Object.values(moment.labels)[0] ?? "";
  const { colour, range } = readingColours(of);
  const picture = handMap(of.channel, { label: `${of.channel.name} at ${name}`, unit: of.channel.unit, size: 250, colour });
  picture.setValues(of.values, range);
  return element("div", { class: "hero-hand" }, [
    picture.element,
    element("p", { class: "small muted" }, [`${capital(of.channel.name)} of the hand while it explores ${name.replaceAll("_", " ")}, at the moment of greatest contact`]),
  ]);
}

const kThingSize = 56;

function thingsOf({ things }: SystemReport): Child {
  const shown = things.filter(hasPicture);
  if (shown.length === 0) return null;
  const scale = commonScale(shown, kThingSize);
  const items = shown.map((thing) => {
    const picture = thingPicture(thing, scale);
    return element("li", {}, [picture, element("span", {}, [thing.name.replaceAll("_", " ")])]);
  });
  const list = element("ul", { class: "hero-things", "aria-label": "Explored things" });
  fill(list, items);
  return list;
}
