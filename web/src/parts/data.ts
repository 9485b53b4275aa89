// Made from web/schema/parts.json by scripts/page_types.py; change the schema.
//
// Data types shared by the report and the view. Numbers are in the accompanying unit; neurons are
// numbered row by row from 0.

/** A number, or null for NaN and infinity, which JSON does not support. */
export type NumberOrNull = number | null;

/** The labels of an exploration: name to value, such as "object" to "boule". */
export type Labels = Record<string, string>;

/**
 * The grid of a map; or, with `edges`, the graph of a map that grows, whose neurons are numbered in
 * one row.
 */
export interface GridData {
  rows: number;
  columns: number;
  lattice: "rectangular" | "hexagonal";
  topology: "plane" | "torus";
  /** Connected neurons, the lower number first. */
  edges?: [number, number][];
  /** For each neuron of a graph the row and column of its cell in a drawing, from 0. */
  cells?: [number, number][];
}

/** For each neuron the index of its class in `classes`; null for a neuron without a class. */
export type NeuronClasses = (number | null)[];

/** The module that is connected to an input port. */
export interface ModuleInput {
  port: string;
  module: string;
}

/** A module of a system, from its TOML and as built. */
export interface ModuleData {
  name: string;
  /** As in docs/reference/modules.md, such as "tensor_product". */
  type: string;
  /** One line about modules of that type. */
  text: string;
  inputs: ModuleInput[];
  /** The shape of one output value; [] for a single number. */
  shape: number[];
  sparse: boolean;
  rate: "frame" | "exploration";
  learns: boolean;
  /** For the type "channel": its channel. */
  channel?: string;
  /** Name to value, in TOML notation. */
  parameters: Record<string, string>;
  /** Names of the parameters that the papers do not give, according to their text. */
  not_given: string[];
}

/** A training phase. */
export interface PhaseData {
  /** Names of modules. */
  learn: string[];
  /** Number of training samples drawn; null: the default of the module. */
  draws: number | null;
  of: "frames" | "explorations";
}

/** The modules of a system, in the order of its description. */
export interface GraphData {
  modules: ModuleData[];
  /** Name of the output map. */
  map: string;
  phases: PhaseData[];
}

/** A channel of a recording. */
export interface ChannelData {
  name: string;
  /** The unit of its values; "" without one. */
  unit: string;
  /** Names of the elements; "1", "2", ... by default. */
  elements: string[];
  /** The shape of a frame. */
  shape: number[];
  /** The places of the elements, if a layout file gives them. */
  layout?: LayoutData;
}

/** The places of the elements of a channel in mm; x grows to the right and y downwards. */
export interface LayoutData {
  /** The usual distance between neighbours. */
  spacing: number;
  /** x and y of each element. */
  places: [number, number][];
  groups: LayoutGroup[];
  background: LayoutBackground | null;
}

/** Elements that are outlined together. */
export interface LayoutGroup {
  name: string;
  /** By index. */
  elements: number[];
}

/** A picture behind the elements, with its place in mm. */
export interface LayoutBackground {
  /** "data:image/png;base64,...". */
  image: string;
  x: number;
  y: number;
  width: number;
  height: number;
}

/** An explored object or material, for its picture. */
export interface ThingData {
  name: string;
  /**
   * sphere, cylinder, block, cone, ellipsoid, capsule, mesh, or another label of a recording; null
   * for a material.
   */
  shape: string | null;
  /** Width, depth and height in mm. */
  size: [number, number, number] | null;
  /** The diameter of the top of a cone, in mm. */
  top_diameter: number;
  /** "" if unknown. */
  material: string;
  /** "" if unknown. */
  hardness: string;
  /** Red, green and blue, 0 to 1; only for display. */
  colour: [number, number, number] | null;
  /** In kg. */
  mass: number | null;
}

/**
 * The weights of each neuron projected onto the elements of a channel (or of a module at which the
 * projection ends): summed over the other factors of tensor products; for one-hot codes the mean of
 * the bins.
 */
export interface ChannelPlanes {
  channel: ChannelData;
  /** The unit of the values; "" for weights without one. */
  unit: string;
  /** values[neuron][element]; null where the weights determine no value. */
  values: NumberOrNull[][];
}
