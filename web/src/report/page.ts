// The whole page: navigation at the side, the overview, claims and curves, and a section a system.

import { breakable, element } from "../parts/dom";
import { themeButton } from "../parts/theme";
import { claimsSection } from "./claims";
import { curvesSection } from "./curves";
import type { ReportData, SystemReport } from "./data";
import { drawInside, tried } from "./lazy";
import { overviewSection } from "./overview";
import { systemSection } from "./system";
import { countOf, systemName } from "./words";

interface Entry {
  id: string;
  name: string;
  isVariation: boolean;
}

export const systemId = (index: number) => `system-${index + 1}`;

export function reportPage(place: HTMLElement, data: ReportData): void {
  const sections = [
    ...tried(() => [overviewSection(data, claimsOfData(data))]),
    ...(data.claims.length > 0 ? tried(() => [claimsSection(data)]) : []),
    ...(data.curves.length > 0 ? tried(() => [curvesSection(data)]) : []),
    ...data.systems.flatMap((system, i) => tried(() => [systemSection(system, i, data)])),
  ];
  document.title = titleOf(data);
  const skip = element("a", { class: "skip", href: "#overview" }, ["To the report"]);
  place.before(skip);
  place.before(navigation(entriesOf(data), data));
  place.append(...sections);
  followLinks();
}

function claimsOfData(data: ReportData): string {
  return data.claims.length === 0 ? "" : countOf(data.claims.length, "claim");
}

function titleOf(data: ReportData): string {
  const [first] = data.systems;
  if (data.systems.length === 1 && first) return `${systemName(first)} – Somato report`;
  return "Somato report";
}

function entriesOf(data: ReportData): Entry[] {
  const systems = data.systems.map((system, i): Entry => entryOf(system, i, data));
  return [
    { id: "overview", name: "Overview", isVariation: false },
    ...(data.claims.length > 0 ? [{ id: "claims", name: "Claims", isVariation: false }] : []),
    ...(data.curves.length > 0 ? [{ id: "curves", name: "Curves", isVariation: false }] : []),
    ...systems,
  ];
}

function entryOf(system: SystemReport, index: number, data: ReportData): Entry {
  const isVariation = system.variation !== "" && data.systems[index - 1]?.name === system.name;
  return { id: systemId(index), name: isVariation ? system.variation : systemName(system), isVariation };
}

function navigation(entries: Entry[], data: ReportData): HTMLElement {
  const links = entries.map(({ id, name, isVariation }) =>
    element("li", { class: isVariation ? "variation" : "" }, [element("a", { href: `#${id}` }, breakable(name))]),
  );
  const list = element("ul", {}, links);
  const brand = element("p", { class: "brand" }, ["Somato", element("span", {}, ["report"])]);
  const fold = element("details", { class: "contents" }, [element("summary", {}, ["Contents"]), list]);
  const wide = matchMedia("(min-width: 960px)");
  const unfold = () => {
    fold.open = wide.matches;
  };
  unfold();
  wide.addEventListener("change", unfold);
  list.addEventListener("click", () => {
    fold.open = wide.matches;
  });
  const foot = element("p", { class: "small muted version" }, [`Somato ${data.somato}`]);
  const parts = [brand, themeButton(), fold, foot];
  return element("nav", { class: "side no-print", "aria-label": "Contents" }, parts);
}

/** Draws what a link leads to before going there, and shows in the list where one is. */
function followLinks(): void {
  const links = [...document.querySelectorAll<HTMLAnchorElement>("nav.side a")];
  addEventListener("hashchange", goToHash);
  if (location.hash !== "") goToHash();
  const sections = [...document.querySelectorAll("main > section")];
  // Sections come and go at this line, a fifth of the way down; asked only then.
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
  drawInside(target);
  target.scrollIntoView();
}

function mark(links: HTMLAnchorElement[], id: string): void {
  for (const link of links) {
    if (link.hash === `#${id}`) link.setAttribute("aria-current", "location");
    else link.removeAttribute("aria-current");
  }
}
