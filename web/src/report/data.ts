// The JSON that `somato report` puts into report.html; docs/formats/report.md says the same in words.

import type {
  ChannelData,
  ChannelPlanes,
  GraphData,
  GridData,
  ReceptiveFields,
  ThingData,
} from "../parts/data";

export interface ReportData {
  version: 1;
  somato: string; // version of the program
  systems: SystemReport[];
  claims: ClaimReport[];
  curves: CurveReport[];
}

export interface MetricData {
  mean: number;
  sd: number;
  values: number[]; // one a seed (or pair of recording and seed)
}

export interface RunData {
  seed: number;
  recording: number; // index into `recordings`
  winners: number[];
  labels: string[];
  predictions: string[];
  other_predictions?: Record<string, string[]>;
}

/** One protocol of a system: as in results.json. */
export interface ProtocolData {
  protocol: string;
  group?: string;
  label: string;
  samples: number;
  metrics: Record<string, MetricData>;
  runs: RunData[];
}

/** One system (or variation of one) of one results.json. */
export interface SystemReport {
  file: string; // the results.json, as it was named on the command line
  place?: string; // what tells it from one of the same name; made here (same_names.ts)
  name: string;
  variation: string; // "" for the system as it stands
  question: string; // "" where it is not part of one
  settings: Record<string, Record<string, string>>; // part, such as "module.map", to settings
  data_hash: string;
  recordings: string[]; // names; one for the results of `somato run`, "" where it is not at hand
  protocols: ProtocolData[];
  graph: GraphData | null;
  grid: GridData | null; // of the map that answers
  // The values of each label of the explorations, in the order of the samples (of all protocols but
  // test_data), where known: those of the first recording that was at hand.
  samples: Record<string, string>[] | null;
  things: ThingData[];
  not_given: NotGiven[];
  // What only the trained system knows, of the seed that is saved; null without system.somato.
  trained: TrainedData | null;
  // A moment of a grasp, where a recording was at hand: of each thing one exploration. [] for
  // variations and questions, which are on recordings like those of the system as it stands.
  moments: MomentData[];
  missing: string[]; // sentences: what is not here and how to get it
}

/** A parameter that no paper gives, with the value taken. */
export interface NotGiven {
  part: string; // "module.map"
  name: string;
  value: string;
  text: string;
}

export interface TrainedData {
  file: string;
  seed: number | null; // of the run whose winners are all its own; null: none, or no recording
  classes: string[];
  neuron_classes: (number | null)[]; // index into classes
  u_matrix: number[]; // mean distance of a neuron's weights from its neighbours'
  hits: number[]; // samples a neuron, of the saved system; [] without a recording
  // Component planes: all elements of a short input, else those of the channels.
  planes: ChannelPlanes[];
  receptive_fields: ReceptiveFields[];
}

/** What the sensors told at one moment and over one exploration. */
export interface MomentData {
  labels: Record<string, string>;
  channels: MomentChannel[];
}

export interface MomentChannel {
  channel: ChannelData;
  rate: number;
  frame: number; // the moment: where most touches, else the last
  time?: number; // of that frame, as in `times`
  values: number[]; // at that frame
  // Over time, at most 200 frames evenly chosen: series[frame][element]; [] where there are more
  // than 64 elements.
  times: number[];
  series: number[][];
}

/** A sentence of a paper, and how often it holds here. */
export interface ClaimReport {
  file: string; // as that of its system
  place?: string; // as that of its system
  question: string; // "" for a claim about a system as its own file has it
  system: string;
  variation: string;
  text: string;
  paper: string; // such as "P11 II-C"; "" for a claim of ours
  metric: string;
  protocol: string;
  group: string;
  than: string; // the other system or variation, or ""
  published: number | null;
  at_least: number | null;
  at_most: number | null;
  values: number[];
  by_luck: number | null; // the wrong-grouping control
  chance_share?: number | null; // share of wrong groupings that meet the bounds
  verdict: string; // see verdictOf() in words.ts
  reason: string; // why it cannot be decided here, or ""
  share: number; // of the values for which it holds
}

/** How something changes with a setting, such as accuracy with the noise of placement. */
export interface CurveReport {
  title: string;
  x: string; // name of the setting
  unit: string;
  metric: string;
  lines: { name: string; points: { x: number; mean: number; sd: number; values: number[] }[] }[];
}
