// The whole page: side navigation, overview, claims and curves, and a section for each system.

import { breakable, element } from "../parts/dom";
import { themeButton } from "../parts/theme";
import { claimsSection } from "./claims";
import { curvesSection } from "./curves";
import type { ReportData } from "./data";
import { questionsOf, standing, systemId, type Numbered } from "./groups";
import { drawInside, tried } from "./lazy";
import { overviewSection } from "./overview";
import { questionSection } from "./question";
import { systemSection } from "./system";
import { systemName } from "./words";

interface Entry {
  id: string;
  name: string;
  isVariation: boolean;
}

export function reportPage(place: HTMLElement, data: ReportData): void {
  const sections = [
    ...tried(() => [overviewSection(data)]),
    ...(data.claims.length > 0 ? tried(() => [claimsSection(data)]) : []),
    ...(data.curves.length > 0 ? tried(() => [curvesSection(data)]) : []),
    ...standing(data).flatMap(({ system, index }) => tried(() => [systemSection(system, index, data)])),
    ...questionsOf(data).flatMap((question) => tried(() => [questionSection(question, data)])),
  ];
  document.title = titleOf(data);
  const skip = element("a", { class: "skip", href: "#overview" }, ["To the report"]);
  place.before(skip);
  place.before(navigation(data));
  place.append(...sections);
  followLinks();
}

function titleOf(data: ReportData): string {
  const [first] = data.systems;
  if (data.systems.length === 1 && first) return `${systemName(first)} – Somato report`;
  return "Somato report";
}

function entriesOf(data: ReportData): Entry[] {
  return [
    { id: "overview", name: "Overview", isVariation: false },
    ...(data.claims.length > 0 ? [{ id: "claims", name: "Claims", isVariation: false }] : []),
    ...(data.curves.length > 0 ? [{ id: "curves", name: "Curves", isVariation: false }] : []),
  ];
}

function systemEntries(systems: Numbered[]): Entry[] {
  return systems.map(({ system, index }, i) => {
    const isVariation = system.variation !== "" && systems[i - 1]?.system.name === system.name;
    return { id: systemId(index), name: isVariation ? system.variation : systemName(system), isVariation };
  });
}

function navigation(data: ReportData): HTMLElement {
  const questions = questionsOf(data).map(({ id, name }) => ({ id, name, isVariation: false }));
  const lists = [
    ...entryList("", entriesOf(data)),
    ...entryList("Systems", systemEntries(standing(data))),
    ...entryList("Questions", questions),
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
  const foot = element("p", { class: "small muted version" }, [`Somato ${data.somato}`]);
  const parts = [brand, themeButton(), fold, foot];
  return element("nav", { class: "side no-print", "aria-label": "Contents" }, parts);
}

function entryList(title: string, entries: Entry[]): HTMLElement[] {
  if (entries.length === 0) return [];
  const links = entries.map(({ id, name, isVariation }) =>
    element("li", { class: isVariation ? "variation" : "" }, [
      element("a", { href: `#${id}` }, breakable(name)),
    ]),
  );
  const list = element("ul", {}, links);
  return title === "" ? [list] : [element("p", { class: "list-title" }, [title]), list];
}

/** Draws the target of a link before scrolling to it, and marks the current section. */
function followLinks(): void {
  const links = [...document.querySelectorAll<HTMLAnchorElement>("nav.side a")];
  addEventListener("hashchange", goToHash);
  if (location.hash !== "") goToHash();
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

function goToHash(): void {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  const fold = target.closest("details");
  if (fold) fold.open = true;
  drawInside(target);
  target.scrollIntoView();
}

function mark(links: HTMLAnchorElement[], id: string): void {
  for (const link of links) {
    if (link.hash === `#${id}`) link.setAttribute("aria-current", "location");
    else link.removeAttribute("aria-current");
  }
}
