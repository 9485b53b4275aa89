// The whole page: side navigation, overview, claims and curves, a comparison, and a section for each
// system with its variations.

import { breakable, element, type Child } from "../../parts/dom";
import { themeButton } from "../../parts/theme";
import { parsedAddress, restoreSection, showFigureInAddress } from "./address";
import { claimsSection } from "../tables/claims";
import { canCompare, compareSection } from "../tables/compare";
import { curvesSection } from "../maps/curves";
import { inferenceSection } from "../inference/section";
import { inferenceId, inferenceTitle } from "../inference/names";
import { groupsOf, questionsOf } from "./groups";
import { drawAllInside, drawInside, tried } from "./lazy";
import { overviewSection, titleOf } from "./overview";
import { questionSection } from "./question";
import { savingControls } from "./saving_controls";
import { systemSection } from "../tables/system";
import type { ReportData } from "./unpacked";

interface Entry {
  id: string;
  name: string;
}

export function reportPage(place: HTMLElement, data: ReportData): void {
  const groups = groupsOf(data);
  const isFolded = groups.length > 1;
  const sections = [
    ...tried(() => [overviewSection(data)]),
    ...(data.inferences ?? []).flatMap((inference, i) => tried(() => [inferenceSection(inference, i)])),
    ...(canCompare(data) ? tried(() => [compareSection(data)]) : []),
    ...groups.flatMap((group) => tried(() => [systemSection(group, data, isFolded)])),
    ...questionsOf(data).flatMap((question) => tried(() => [questionSection(question, data)])),
    ...(data.curves.length > 0 ? tried(() => [curvesSection(data)]) : []),
    ...(data.claims.length > 0 ? tried(() => [claimsSection(data)]) : []),
  ];
  document.title = `${titleOf(data)} – Somato report`;
  const skip = element("a", { class: "skip", href: "#overview" }, ["To the report"]);
  place.before(skip);
  place.before(navigation(data));
  place.append(...sections);
  followLinks();
}

function navigation(data: ReportData): HTMLElement {
  const part = (id: string, name: string, isThere: boolean): Entry[] => (isThere ? [{ id, name }] : []);
  const lists = [
    ...entryList("", [
      { id: "overview", name: "Overview" },
      ...part("compare", "Side by side", canCompare(data)),
      ...part("curves", "Curves", data.curves.length > 0),
      ...part("claims", "Claims", data.claims.length > 0),
    ]),
    ...entryList("Inferences", inferencesOf(data)),
    ...entryList("Systems", groupsOf(data)),
    ...entryList("Questions", questionsOf(data)),
  ];
  const brand = element("p", { class: "brand" }, ["Somato", element("span", {}, ["report"])]);
  const fold = element("details", { class: "contents" }, [element("summary", {}, ["Contents"]), ...lists]);
  const wide = matchMedia("(min-width: 960px)");
  const unfold = () => {
    fold.open = wide.matches;
  };
  unfold();
  wide.addEventListener("change", unfold);
  lists.forEach((list) => list.addEventListener("click", unfold));
  const parts: Child[] = [brand, themeButton(), fold, savingControls(data)];
  return element("nav", { class: "side no-print", "aria-label": "Contents" }, parts);
}

function inferencesOf({ inferences = [] }: ReportData): Entry[] {
  return inferences.map((inference, i) => ({ id: inferenceId(i), name: inferenceTitle(inference) }));
}

function entryList(title: string, entries: Entry[]): HTMLElement[] {
  if (entries.length === 0) return [];
  const links = entries.map(({ id, name }) =>
    element("li", {}, [element("a", { href: `#${id}` }, breakable(name))]),
  );
  const list = element("ul", {}, links);
  return title === "" ? [list] : [element("p", { class: "list-title" }, [title]), list];
}

/** Draws the target of a link before scrolling to it, and marks the current section. */
function followLinks(): void {
  const links = [...document.querySelectorAll<HTMLAnchorElement>("nav.side a")];
  addEventListener("hashchange", goToAddress);
  addEventListener("click", putFigureInAddress);
  if (location.hash !== "") goToAddress();
  const sections = [...document.querySelectorAll("main > section")];
  // The current section is that at a fifth of the height.
  const atLine = { rootMargin: "-20% 0px -79% 0px" };
  const watcher = new IntersectionObserver(() => mark(links, sectionAtLine(sections)), atLine);
  sections.forEach((section) => watcher.observe(section));
}

function sectionAtLine(sections: Element[]): string {
  const above = sections.filter((section) => section.getBoundingClientRect().top <= innerHeight / 5 + 1);
  return (above.at(-1) ?? sections[0])?.id ?? "";
}

function goToAddress(): void {
  const address = parsedAddress(location.hash);
  const section = restoreSection(address);
  if (!section) return;
  openAround(section);
  drawInside(section);
  if (!document.getElementById(address.id)) drawAllInside(section);
  const target = document.getElementById(address.id) ?? section;
  openAround(target);
  target.scrollIntoView();
}

function openAround(target: Element): void {
  for (let fold = target.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null) fold.open = true;
}

/** The address of a figure contains the selection with which it is shown. */
function putFigureInAddress(event: Event): void {
  const link = event.target instanceof Element ? event.target.closest<HTMLAnchorElement>("a.figure-link") : null;
  if (!link) return;
  event.preventDefault();
  showFigureInAddress(parsedAddress(link.hash).id);
}

function mark(links: HTMLAnchorElement[], id: string): void {
  for (const link of links) {
    if (link.hash === `#${id}`) link.setAttribute("aria-current", "location");
    else link.removeAttribute("aria-current");
  }
}
