// The data of the report as its figures use them: lists of numbers that the file packs are lists
// again, and each system has the readings of its explorations (web/schema/report.json).

import type { NumberOrNull } from "../../parts/data";
import type * as file from "../data";

export type {
  CalibratedData,
  ClaimReport,
  ConflictData,
  CurveReport,
  DependenceData,
  InferenceReport,
  MetricData,
  NotGiven,
  SupportedClaim,
  TargetData,
  UnknownCell,
  UnknownData,
} from "../data";

export type Unpacked<T> = T extends file.PackedRows
  ? NumberOrNull[][]
  : T extends file.PackedNumbers
    ? number[]
    : T extends unknown[]
      ? number extends T["length"]
        ? Unpacked<T[number]>[]
        : T
      : T extends object
        ? { [Key in keyof T]: Unpacked<T[Key]> }
        : T;

export type MomentChannel = Unpacked<file.MomentChannel>;
export type MomentData = Unpacked<file.MomentData>;
export type ProtocolData = Unpacked<file.ProtocolData>;
export type RunData = Unpacked<file.RunData>;
export type RunMap = Unpacked<file.RunMap>;
export type ReceptiveFields = Unpacked<file.ReceptiveFields>;
export type DecidingData = Unpacked<file.DecidingData>;
export type TrainedData = Unpacked<file.TrainedData>;
export type SystemReport = Omit<Unpacked<file.SystemReport>, "moments"> & {
  moments: (MomentData | null)[]; // of each sample
};
export type ReportData = Omit<Unpacked<file.ReportData>, "systems" | "moments" | "placed"> & { systems: SystemReport[] };

/** The same with every packed list unpacked. */
export function unpacked(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(unpacked);
  if (typeof value !== "object" || value === null) return value;
  if (isPacked(value)) return "columns" in value ? rowsOf(value as file.PackedRows) : numbersOf(value);
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, unpacked(one)]));
}

function isPacked(value: object): value is file.PackedNumbers {
  return "bits" in value && "packed" in value && "low" in value && "high" in value;
}

function rowsOf(packed: file.PackedRows): NumberOrNull[][] {
  const numbers = numbersOf(packed).map((number) => (Number.isNaN(number) ? null : number));
  const columns = Math.max(1, packed.columns);
  return Array.from({ length: Math.floor(numbers.length / columns) }, (_, row) =>
    numbers.slice(row * columns, (row + 1) * columns),
  );
}

const kFigures = 6; // significant ones, as all other numbers of the file have

/** The numbers; NaN for a missing one, which has the largest integer. */
function numbersOf({ bits, low, high, packed }: file.PackedNumbers): number[] {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const missing = 2 ** bits - 1;
  const step = (high - low) / (missing - 1);
  const integers = Array.from({ length: (8 * bytes.length) / bits }, (_, i) =>
    bits === 8 ? bytes[i]! : bytes[2 * i]! + 256 * bytes[2 * i + 1]!,
  );
  return integers.map((one) => (one === missing ? Number.NaN : Number((low + one * step).toPrecision(kFigures))));
}
