// What the report and the view are told in the same way. Numbers are in the unit that stands beside
// them; neurons are numbered row after row from 0.

export interface GridData {
  rows: number;
  columns: number;
  lattice: "rectangular" | "hexagonal";
  topology: "plane" | "torus";
}

/** A module of a system, as its TOML says and as it was built. */
export interface ModuleData {
  name: string;
  type: string; // as in docs/reference/modules.md, such as "tensor_product"
  text: string; // what a module of that type does, one line
  inputs: { port: string; module: string }[];
  shape: number[]; // of one value; [] for a single number
  sparse: boolean;
  rate: "frame" | "exploration";
  learns: boolean;
  channel?: string; // of type "channel": the channel it takes
  parameters: Record<string, string>; // name to value, as TOML writes it
  // Parameters whose text says that no paper gives them.
  not_given: string[];
}

export interface GraphData {
  modules: ModuleData[];
  map: string; // the module that answers
  phases: { learn: string[]; draws: number | null; of: "frames" | "explorations" }[];
}

export interface ChannelData {
  name: string;
  unit: string;
  elements: string[]; // names; "1", "2", ... where nobody named them
  shape: number[];
}

/** Something that was explored, for its picture. Sizes in mm. */
export interface ThingData {
  name: string;
  shape: "sphere" | "cylinder" | "block" | "cone" | "ellipsoid" | "capsule" | "mesh" | null;
  size: [number, number, number] | null; // width, depth, height
  top_diameter: number;
  material: string;
  hardness: string;
  colour: [number, number, number] | null; // 0 to 1
  mass: number | null; // kg
}

/** For each neuron what its weights stand for at the elements of a channel (or of a module, where the
 * way back ends before one): the weights summed over everything else that they are crossed with; of
 * one-hot codes the mean of the bins. values[neuron][element]. */
export interface ChannelPlanes {
  channel: ChannelData;
  unit: string; // of the values; "" for weights without one
  values: (number | null)[][]; // null where the weights say nothing
}

/** From which elements of its input a T-MPSOM's neurons hear. weights[neuron][element]; where there
 * are more than `limit` numbers only every so-and-so-manieth neuron stands there. */
export interface ReceptiveFields {
  module: string;
  shape: [number, number]; // neurons along either axis
  input: string; // the module that comes in
  axis: 0 | 1; // along which axis of the neurons the input lies
  elements: number;
  neurons: number[]; // the numbers of those that follow
  weights: number[][];
}
