// Reads the data that `somato report` wrote into the page. Missing fields are replaced by empty
// values, so that the report of another version of the program is shown as far as possible.

import {
  unpacked,
  type ClaimReport,
  type DecidingData,
  type MomentData,
  type ProtocolData,
  type ReportData,
  type SystemReport,
  type TrainedData,
} from "./unpacked";
import { withLayouts } from "./layouts";
import { withPlaces } from "./same_names";

export type Read = { data: ReportData } | { problem: string };

const kMakeAnother = "Create the page again with: somato report RESULTS.json -o report.html";

export function readReport(text: string): Read {
  if (text.trim() === "" || text.trim() === "null") {
    return { problem: `This page contains no results. ${kMakeAnother}` };
  }
  let parsed: unknown;
  try {
    parsed = JSON.parse(text);
  } catch (problem) {
    return { problem: `The results in this page are damaged (${String(problem)}). ${kMakeAnother}` };
  }
  try {
    return checked(withLayouts(unpacked(parsed)));
  } catch (problem) {
    return { problem: `The numbers in this page are damaged (${String(problem)}). ${kMakeAnother}` };
  }
}

const kVersion = 2;

function checked(parsed: unknown): Read {
  if (!isObject(parsed)) return { problem: `The results in this page are not a report. ${kMakeAnother}` };
  if (parsed["version"] !== kVersion) {
    const version = String(parsed["version"]);
    return {
      problem: `The results in this page have version ${version}; this page reads version ${kVersion}. ${kMakeAnother}`,
    };
  }
  const moments = listOf(parsed["moments"]) as MomentData[];
  const somato = String(parsed["somato"] ?? "");
  const systems = listOf(parsed["systems"])
    .filter(isObject)
    .map((system) => ({ ...completed(system, moments), somato }));
  const [claims, curves] = [listOf(parsed["claims"]) as ClaimReport[], listOf(parsed["curves"])];
  return {
    data: {
      ...parsed,
      somato,
      ...withPlaces(systems, claims),
      curves,
    } as unknown as ReportData,
  };
}

/** A system without data. */
export function emptySystem(): SystemReport {
  return {
    file: "",
    name: "",
    variation: "",
    question: "",
    settings: {},
    data_hash: "",
    summary: null,
    recordings: [],
    recording: null,
    protocols: [],
    graph: null,
    grid: null,
    samples: null,
    things: [],
    not_given: [],
    trained: null,
    deciding: null,
    moments: [],
    missing: [],
  };
}

const kEmptyProtocol: ProtocolData = { protocol: "", label: "", samples: 0, metrics: {}, runs: [] };

const kEmptyTrained: TrainedData = {
  file: "",
  seed: null,
  classes: [],
  neuron_classes: [],
  u_matrix: [],
  winners: [],
  hits: [],
  planes: [],
  receptive_fields: [],
};

const kEmptyDeciding: DecidingData = { label: "", unit: "", products: false, sources: [], decisions: [] };

function completed(system: Record<string, unknown>, moments: MomentData[]): SystemReport {
  const whole: SystemReport = { ...emptySystem(), ...given(system) };
  const moment = (number: unknown) => (typeof number === "number" ? (moments[number] ?? null) : null);
  const protocols = listOf(whole.protocols).filter(isObject);
  return {
    ...whole,
    moments: listOf(system["moments"]).map(moment),
    protocols: protocols.map((protocol) => ({ ...kEmptyProtocol, ...given(protocol) })),
    trained: isObject(whole.trained) ? { ...kEmptyTrained, ...given(whole.trained) } : null,
    deciding: isObject(whole.deciding) ? { ...kEmptyDeciding, ...given(whole.deciding) } : null,
  };
}

function given(from: object): Record<string, unknown> {
  return Object.fromEntries(
    Object.entries(from).filter(([, value]) => value !== null && value !== undefined),
  );
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function listOf(value: unknown): unknown[] {
  return Array.isArray(value) ? value : [];
}
