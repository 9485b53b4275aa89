// The explored objects and materials, with pictures at the same scale.

import type { Table } from "../../parts/csv";
import type { ThingData } from "../../parts/data";
import { element, type Child } from "../../parts/dom";
import { figure, scrolled } from "../../parts/figure";
import { capital, fixed, readable } from "../../parts/numbers";
import { commonScale, hasPicture, thingPicture } from "../../parts/hands/thing_picture";
import type { SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

const kSize = 84;


export function thingsFigure(system: SystemReport): Child {
  const { things } = system;
  const scale = commonScale(things, kSize);
  const columns = columnsOf(things);
  const head = columns.map(({ name, isNumber }) =>
    element("th", { scope: "col", class: isNumber ? "number" : "" }, [name]),
  );
  const table = element("table", { class: "things" }, [
    element("thead", {}, [element("tr", {}, [element("td", {}), ...head])]),
    element(
      "tbody",
      {},
      things.map((thing) => thingRow(thing, scale, columns)),
    ),
  ]);
  return figure({
    title: "Things",
    file: `${systemName(system)}-things`,
    body: scrolled("Things", table),
    numbers: () => thingsTable(things),
    printed: { note: "Sizes are width × depth × height.", table: () => printedThings(things, columns) },
    note: noteOf(things),
    wide: true,
  });
}

function noteOf(things: ThingData[]): string {
  const isKnown = (thing: ThingData) => thing.size !== null || thing.shape === null;
  if (things.every((thing) => thing.size === null)) {
    return things.every(isKnown) ? "" : "Only the shapes are drawn; the sizes are unknown.";
  }
  const others = things.every(isKnown) ? "" : " Only the shape is drawn if the size is unknown.";
  return `All are drawn at the same scale; width × depth × height.${others}`;
}

interface Column {
  name: string;
  isNumber: boolean;
  value: (thing: ThingData) => string;
}

const kColumns: Column[] = [
  { name: "name", isNumber: false, value: (thing) => thing.name },
  { name: "shape", isNumber: false, value: (thing) => thing.shape ?? "" },
  { name: "size, mm", isNumber: true, value: sizeWords },
  { name: "material", isNumber: false, value: (thing) => thing.material.replaceAll("_", " ") },
  { name: "hardness", isNumber: false, value: (thing) => thing.hardness },
  {
    name: "mass, g",
    isNumber: true,
    value: (thing) => (thing.mass === null ? "" : grams(thing.mass)),
  },
];

/** The columns that are not empty. */
function columnsOf(things: ThingData[]): Column[] {
  return kColumns.filter(({ value }) => things.some((thing) => value(thing) !== ""));
}

/** Whole grams: a table of heavy and light things has equally many decimals. */
function grams(kilograms: number): string {
  const mass = kilograms * 1000;
  return mass < 10 ? readable(mass) : fixed(mass, 0);
}

function sizeWords(thing: ThingData): string {
  if (thing.size === null) return "";
  const words = thing.size.map((one) => readable(one)).join(" × ");
  return thing.top_diameter > 0 ? `${words}, top ${readable(thing.top_diameter)}` : words;
}

function thingRow(thing: ThingData, scale: number, columns: Column[]): HTMLElement {
  const [first, ...rest] = columns;
  return element("tr", {}, [
    element("td", { class: "thing" }, hasPicture(thing) ? [thingPicture(thing, scale)] : []),
    element("th", { scope: "row" }, [first?.value(thing) ?? ""]),
    ...rest.map(({ value, isNumber }) => element("td", { class: isNumber ? "number" : "" }, [value(thing)])),
  ]);
}

/** As on the page, without the pictures. */
function printedThings(things: ThingData[], columns: Column[]): Table {
  const rows = things.map((thing) => columns.map(({ value }) => value(thing).replaceAll("_", " ")));
  return { columns: columns.map(({ name }) => capital(name)), rows };
}

function thingsTable(things: ThingData[]): Table {
  const columns = [
    "name",
    "shape",
    "width (mm)",
    "depth (mm)",
    "height (mm)",
    "top diameter (mm)",
    "material",
    "hardness",
    "mass (kg)",
  ];
  const rows = things.map((thing) => [
    thing.name,
    thing.shape,
    ...(thing.size ?? [null, null, null]),
    thing.top_diameter,
    thing.material,
    thing.hardness,
    thing.mass,
  ]);
  return { columns, rows };
}
