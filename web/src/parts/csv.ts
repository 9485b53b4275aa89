// Tables as CSV (RFC 4180): a field with a comma, a quote or a line break is quoted. A text that a
// spreadsheet would interpret as a formula is prefixed by an apostrophe, because names are untrusted
// input; docs/formats/tables.md states the rule, which makes texts readable again.

export type Cell = string | number | null;

export interface Table {
  columns: string[];
  rows: Cell[][];
}

export function csv(table: Table): string {
  return [table.columns, ...table.rows].map((row) => row.map(field).join(",")).join("\r\n") + "\r\n";
}

const formula = /^'*[=+\-@\t\r]/;
const guardedNumber = /^'*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

function field(cell: Cell): string {
  if (cell === null || (typeof cell === "number" && !Number.isFinite(cell))) return "";
  if (typeof cell === "number") return String(cell);
  const safe = formula.test(cell) && !guardedNumber.test(cell) ? `'${cell}` : cell;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
