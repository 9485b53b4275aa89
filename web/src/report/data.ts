// Made from web/schema/report.json by scripts/page_types.py; change the schema.
//
// The JSON that `somato report` writes into report.html, documented in docs/formats/report.md.

import type {
  ChannelData,
  GraphData,
  GridData,
  Labels,
  NeuronClasses,
  NumberOrNull,
  ThingData,
} from "../parts/data";

/** The whole report. */
export interface ReportData {
  version: 2;
  /** Version of the program. */
  somato: string;
  systems: SystemReport[];
  claims: ClaimReport[];
  curves: CurveReport[];
  /** Sensor readings of explorations, each once, although several systems may refer to it. */
  moments: MomentData[];
  /**
   * The channels of moments and planes whose elements have places, with their `layout`, which is
   * not repeated there.
   */
  placed?: ChannelData[];
  inferences?: InferenceReport[];
}

/**
 * A list of numbers. Integer i stands for low + i * (high - low) / (2^bits - 2); the largest
 * integer, 2^bits - 1, for a missing number.
 */
export interface PackedNumbers {
  /** The size of an integer. */
  bits: 8 | 16;
  low: number;
  high: number;
  /** Unsigned integers, the lower byte first, in base64 (RFC 4648, section 4). */
  packed: string;
}

/** Rows of numbers, one after the other, as PackedNumbers. */
export interface PackedRows {
  /** Numbers in a row. */
  columns: number;
  /** The size of an integer. */
  bits: 8 | 16;
  low: number;
  high: number;
  /** As in PackedNumbers. */
  packed: string;
}

/** A metric over the runs of a protocol. */
export interface MetricData {
  mean: NumberOrNull;
  /** Standard deviation. */
  sd: NumberOrNull;
  /** One for each seed (or pair of recording and seed). */
  values: NumberOrNull[];
}

/** One run of a protocol. Winners, labels and predictions are in the order of the samples. */
export interface RunData {
  seed: number;
  /** Index into `recordings`. */
  recording: number;
  winners: number[];
  labels: string[];
  predictions: string[];
  /** Predictions of other labels, by the name of the label. */
  other_predictions?: Record<string, string[]>;
  /**
   * The map by which all samples were tested; without it there were several, or the results are of
   * an earlier version.
   */
  map?: RunMap;
}

/** The map of one training. */
export interface RunMap {
  grid: GridData;
  /** For each neuron the mean distance between its weights and those of its neighbours. */
  u_matrix: PackedNumbers;
  /** For each edge of a graph the distance between the weights of the connected neurons. */
  edge_distances?: number[];
}

/** One protocol of a system, as in results.json. */
export interface ProtocolData {
  protocol: string;
  /** The label whose values are left out in turn. */
  group?: string;
  /** The label that is predicted. */
  label: string;
  samples: number;
  /** By their names. */
  metrics: Record<string, MetricData>;
  runs: RunData[];
  /**
   * For each sample the number of the training by which it was tested, the same in every run;
   * without it there was only one, or one for each sample, or they are unknown.
   */
  folds?: number[];
}

/** The main result of a system, and what to try next. */
export interface SystemSummary {
  /** Index into `protocols`. */
  protocol: number;
  accuracy: NumberOrNull;
  /** The standard deviation over the runs. */
  deviation: NumberOrNull;
  /** The accuracy of the nearest neighbour; null if it was not measured. */
  baseline: NumberOrNull;
  /** The accuracy that is expected if the predicted classes are in random order. */
  chance: number;
  /** The most frequent ones, over all runs. */
  confusions: Confusion[];
  /**
   * How far the map is from the best nearest neighbour, and whether neighbouring explorations are
   * alike.
   */
  sentences: string[];
  next: NextStep[];
}

/** Samples of a class for which another one was predicted. */
export interface Confusion {
  /** The true class. */
  label: string;
  predicted: string;
  count: number;
  /** All samples of the true class. */
  of: number;
}

/** A proposal for the user of a result. */
export interface NextStep {
  text: string;
  /** Commands of a shell. */
  commands: string[];
  /** A page of the documentation; "": none. */
  page: string;
}

/** One system (or variation of one) of one results.json. */
export interface SystemReport {
  /** The results.json, as it was named on the command line. */
  file: string;
  name: string;
  /** "" for the original system. */
  variation: string;
  /** "" if it is not part of one. */
  question: string;
  /** Every parameter in TOML notation: part, such as "module.map", to name to value. */
  settings: Record<string, Record<string, string>>;
  /** Hash of the first of its recordings that was available, else of its first. */
  data_hash: string;
  summary: SystemSummary | null;
  /** Names. */
  recordings: string[];
  /**
   * Index into `recordings` of the one with the `samples` and `moments`; null without a recording.
   */
  recording: number | null;
  protocols: ProtocolData[];
  graph: GraphData | null;
  /** The grid of the output map. */
  grid: GridData | null;
  /**
   * The labels of each exploration, in the order of the samples (of all protocols except
   * test_data), from the first available recording.
   */
  samples: Labels[] | null;
  things: ThingData[];
  not_given: NotGiven[];
  /** Data of the trained system, for the saved seed; null without system.somato. */
  trained: TrainedData | null;
  /**
   * The contributions of sensors to decisions of the trained system; null without it or a
   * recording, and for maps whose neurons have fewer than two classes.
   */
  deciding: DecidingData | null;
  /**
   * For each sample the number of its readings in the `moments` of the report, or null; [] without
   * a recording. For variations and questions only readings that an earlier original system refers
   * to.
   */
  moments: (number | null)[];
  /** Sentences that state what is missing and how to obtain it. */
  missing: string[];
}

/** A parameter that no paper gives, with the value used. */
export interface NotGiven {
  /** Such as "module.map". */
  part: string;
  name: string;
  /** In TOML notation. */
  value: string;
  /** Its documentation. */
  text: string;
}

/** The output map of the trained system. */
export interface TrainedData {
  file: string;
  /** The seed of the run in which it was trained; null: unknown. */
  seed: number | null;
  classes: string[];
  neuron_classes: NeuronClasses;
  /** For each neuron the mean distance between its weights and those of its neighbours. */
  u_matrix: number[];
  /** For each sample the neuron of the saved system that wins it; [] without a recording. */
  winners: number[];
  /** For each neuron the number of samples, of the saved system; [] without a recording. */
  hits: number[];
  /** Component planes: all elements of a short input, else those of the channels. */
  planes: PackedPlanes[];
  receptive_fields: ReceptiveFields[];
}

/** The component planes of a channel, as ChannelPlanes of parts.json. */
export interface PackedPlanes {
  channel: ChannelData;
  /** The unit of the values; "" for weights without one. */
  unit: string;
  /**
   * A row for each neuron, a column for each element; missing where the weights determine no value.
   */
  values: PackedRows;
}

/**
 * Contributions that separate two classes, for single samples: some that the tests confused, others
 * that are almost as far from both classes.
 */
export interface DecidingData {
  /** The label whose classes are compared. */
  label: string;
  /** The unit of distances and contributions; "" without one. */
  unit: string;
  /** Whether the map compares inner products, of which the nearest neuron has the greatest. */
  products: boolean;
  sources: DecidingSource[];
  decisions: DecisionData[];
}

/** The elements to which contributions are traced back. */
export interface DecidingSource {
  /**
   * A channel; or the output of a module that cannot be traced further. Without elements if it has
   * more than 1024.
   */
  channel: ChannelData;
  is_channel: boolean;
  /**
   * A row for each decision, a column for each element; missing where the system does not read the
   * element. No columns without elements.
   */
  values: PackedRows;
}

/**
 * A sample and two classes, those of a confusion of the tests or those of the nearest neurons;
 * numbers and classes are those of the trained system.
 */
export interface DecisionData {
  /** Index into `samples`. */
  sample: number;
  /** The true class. */
  label: string;
  /** The number of runs of the main result that tested the sample. */
  tests: number;
  /** A wrong class that tests named; "": none. */
  predicted: string;
  /** The number of runs that named it. */
  confused: number;
  /** The class of the nearest neuron of all. */
  answer: string;
  /** That of the two classes whose neuron is nearer. */
  nearest: string;
  /** The other of the two. */
  other: string;
  /** The distance of the nearest neuron of the class `nearest`. */
  of_nearest: number;
  /** The distance of the nearest neuron of the class `other`. */
  of_other: number;
  /**
   * For each source the sum of its contributions; together they are the difference of the two
   * distances.
   */
  sums: number[];
}

/**
 * The receptive fields of a T-MPSOM's neurons along one input. For more than 20000 numbers only
 * every k-th neuron is included.
 */
export interface ReceptiveFields {
  module: string;
  /** Neurons along either axis. */
  shape: [number, number];
  /** The module that is connected. */
  input: string;
  /** The axis of the neurons along which the input lies. */
  axis: 0 | 1;
  /** The size of the input. */
  elements: number;
  /** Numbers of the neurons in `weights`. */
  neurons: number[];
  /** A row for each of `neurons`, a column for each element: arbor times weight. */
  weights: PackedRows;
}

/** The sensor readings at one moment and over one exploration. */
export interface MomentData {
  labels: Labels;
  channels: MomentChannel[];
}

/** One channel at the moment, and evenly chosen frames of the exploration, at most 200. */
export interface MomentChannel {
  channel: ChannelData;
  /** Frames per second; 0 if unknown. */
  rate: number;
  /** The moment: the frame with the greatest sum of `touch`, else the last. */
  frame: number;
  /** The time of that frame, as in `times`. */
  time: number;
  /** At that frame, one for each element. */
  values: NumberOrNull[];
  /** The times of the chosen frames, in seconds; the number of the frame if times are unknown. */
  times: PackedNumbers;
  /** A row for each chosen frame, a column for each element; no rows for more than 64 elements. */
  series: PackedRows;
}

/** A claim, and how often it holds. */
export interface ClaimReport {
  /** As that of its system. */
  file: string;
  /** "" for a claim in the file of a system. */
  question: string;
  system: string;
  variation: string;
  text: string;
  /** Such as "P11 II-C"; "" for an additional comparison. */
  paper: string;
  metric: string;
  protocol: string;
  group: string;
  /** The other system or variation, or "". */
  than: string;
  /** The metric of the other system or variation, or "". */
  than_metric: string;
  published: number | null;
  at_least: number | null;
  at_most: number | null;
  /** The values of the metric, or of the difference, one for each pair of recording and seed. */
  values: NumberOrNull[];
  /** Mean of the metric on wrong groupings. */
  by_chance: number | null;
  /** Share of wrong groupings that meet the bounds. */
  chance_share: number | null;
  verdict: "holds" | "holds, but so does chance" | "mostly" | "fails" | "cannot be decided here";
  /** Why it cannot be decided, or "". */
  reason: string;
  /** Share of the values for which it holds. */
  share: number;
  /** The figure of its paper that contradicts it. */
  contradicted_by?: string;
  as_written?: WrittenClaim;
}

/** The second measure of a claim, which follows the words of its text. */
export interface WrittenClaim {
  verdict: "holds" | "holds, but so does chance" | "compatible" | "compatible, but no narrower than chance" | "mostly" | "not determined" | "fails" | "cannot be decided here";
  /** Why it cannot be decided, or "". */
  reason: string;
  /** The measured quantity, the bounds, the mean, the ranges and the share. */
  summary: string;
}

/** A metric at one value of the setting. */
export interface CurvePoint {
  x: number;
  mean: NumberOrNull;
  /** Standard deviation. */
  sd: NumberOrNull;
  values: NumberOrNull[];
}

/** The curve of one system. */
export interface CurveLine {
  name: string;
  points: CurvePoint[];
}

/** A metric as a function of a setting, such as accuracy and placement noise. */
export interface CurveReport {
  title: string;
  /** Name of the setting. */
  x: string;
  /** The unit of the setting; "" without one. */
  unit: string;
  metric: string;
  lines: CurveLine[];
}

/** An inference, as in inference.json: its prior, its posterior and its claims. */
export interface InferenceReport {
  /** The inference.json, as it was named on the command line. */
  file: string;
  /** Names. */
  systems: string[];
  /** Settings of the prior that were run. */
  draws: number;
  /** Maps of each system at each draw. */
  pairs: number;
  /** Maps that were accepted. */
  accepted: number;
  /** Whether the accepted settings were adjusted by a regression. */
  adjusted: boolean;
  /** Settings of the posterior that were run with fresh seeds. */
  bodies: number;
  /** Maps of each system at each of these. */
  fresh_pairs: number;
  targets: TargetData[];
  unknowns: UnknownData[];
  dependences: DependenceData[];
  /** Draws that were taken as observations, to check the inference. */
  truths: number;
  /** For each unknown. */
  calibration: CalibratedData[];
  claims: SupportedClaim[];
  conflicts: ConflictData[];
  joint: JointResults;
}

/** A value that was observed. */
export interface TargetData {
  text: string;
  paper: string;
  system: string;
  variation: string;
  metric: string;
  protocol: string;
  observed: number;
  /** The difference that counts as 1. */
  scale: number;
  /** Mean over all maps. */
  prior: number;
  /** Mean over the accepted maps. */
  posterior: number;
}

/** A setting that is inferred. */
export interface UnknownData {
  name: string;
  /** Why it is unknown, with its unit and the source of its range. */
  text: string;
  /** The value of the system's file, in TOML notation. */
  system: string;
  /** Keys of the system's file. */
  key: string[];
  /** Parts of the range, or single values. */
  cells: UnknownCell[];
  prior: UnknownSummary;
  posterior: UnknownSummary;
  /** The width of the posterior relative to that of the prior. */
  shrinkage: number;
}

/** A part of the range of an unknown; a single value has equal ends. */
export interface UnknownCell {
  from: number | string | boolean;
  to: number | string | boolean;
  /** Share of the draws. */
  prior: number;
  /** Weighted share of the accepted maps. */
  posterior: number;
}

/** Quantiles of 0.05, 0.5 and 0.95. */
export interface UnknownSummary {
  low: number | string | boolean;
  median: number | string | boolean;
  high: number | string | boolean;
}

/** The correlation of two unknowns in the posterior. */
export interface DependenceData {
  first: string;
  second: string;
  correlation: number;
}

/** The check of an unknown. */
export interface CalibratedData {
  name: string;
  /** Share of the truths in the central 90 % interval. */
  covered: number;
  /** Probability of such ranks if they are uniform. */
  uniform_p: number;
  /** The rank of each truth among the accepted settings. */
  ranks: number[];
}

/** The shares of maps in which a claim holds. */
export interface SupportedClaim {
  text: string;
  paper: string;
  system: string;
  variation: string;
  metric: string;
  protocol: string;
  /** The other system or variation, or "". */
  than: string;
  /** The metric of the other system or variation, or "". */
  than_metric: string;
  published: number | null;
  at_least: number | null;
  at_most: number | null;
  /** The share of all draws. */
  prior: number | null;
  /** The share of the maps accepted without the targets that have its own measure. */
  left_out: number | null;
  /** The share of posterior settings with fresh seeds. */
  fresh: number | null;
  /** The share of wrong groupings of the draws. */
  chance: number | null;
  /** The share of wrong groupings of the fresh maps. */
  fresh_chance: number | null;
  /** On all fresh maps together, by its first measure. */
  fresh_verdict: string | null;
  /** The same by its second measure, if it has one. */
  fresh_verdict_as_written: string | null;
  support: "explained" | "reachable" | "excluded" | "not decided";
}

/** A claim of an inference. */
export interface ClaimName {
  system: string;
  variation: string;
  text: string;
}

/** Two claims that hold together in fewer maps than expected from their shares. */
export interface ConflictData {
  first: ClaimName;
  second: ClaimName;
  /** Number of maps. */
  together: number;
  expected: number;
  /** The difference in standard deviations. */
  deviations: number;
}

/** How many claims hold together. */
export interface JointResults {
  prior: JointSums;
  fresh: JointSums;
}

/** Over the settings of the prior, or those that were run with fresh seeds. */
export interface JointSums {
  mean: number;
  /** For each setting the mean number of claims that hold in a pair. */
  sums: number[];
  /** Claims that do not fail on all pairs together. */
  not_failing: number;
  /** The same by their second measures. */
  not_failing_as_written: number;
}
