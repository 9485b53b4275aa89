// Tables whose columns are defined once, for the page and for saved files.

import type { Cell, Table } from "../../parts/csv";
import { element, type Child } from "../../parts/dom";
import { scrolled } from "../../parts/figure";

export interface Column<One> {
  name: string;
  value: (one: One) => Cell; // in saved files
  shown?: (one: One) => Child[]; // on the page; without it the column is in files only
  kind?: "name" | "claim" | "number"; // of its cells; without it they are texts
}

export function shownTable<One>(label: string, columns: Column<One>[], all: readonly One[]): HTMLElement {
  const visible = columns.filter(({ shown }) => shown);
  const head = visible.map(({ name, kind }) => element("th", { scope: "col", class: kind === "number" ? "number" : "" }, [name]));
  const rows = all.map((one) => element("tr", {}, visible.map((column) => cellOf(column, one))));
  const table = element("table", { class: "wide-table" }, [
    element("thead", {}, [element("tr", {}, head)]),
    element("tbody", {}, rows),
  ]);
  return scrolled(label, table);
}

function cellOf<One>({ shown, kind }: Column<One>, one: One): HTMLElement {
  const children = shown?.(one) ?? [];
  if (kind === "name") return element("th", { scope: "row" }, children);
  return element("td", { class: kind ?? "" }, children);
}

export function savedTable<One>(columns: Column<One>[], all: readonly One[]): Table {
  return { columns: columns.map(({ name }) => name), rows: all.map((one) => columns.map(({ value }) => value(one))) };
}
