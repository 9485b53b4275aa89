// Made from web/schema/view.json by scripts/page_types.py; change the schema.
//
// The HTTP API of `somato view`, documented in docs/formats/view.md as a basis for other pages.
// `Events` are the server-sent events of GET /api/events, `Answers` the answers of GET /api/NAME. A
// Command is sent by POST /api/command, which answers with Done; a refused command or question is
// answered with Refusal and the status 400. Every request contains the token of the start address,
// as ?token= or in the header X-Somato-Token; a POST must come from the origin of the page.

import type {
  ChannelData,
  ChannelPlanes,
  GraphData,
  GridData,
  Labels,
  NeuronClasses,
  NumberOrNull,
  ThingData,
} from "../parts/data";

/** The data of each event, by its name. */
export interface Events {
  /** The first event; sent again when the state changes. */
  state: State;
  /** Sent when the scene changes; null if it is unknown. */
  scene: Scene | null;
  frame: Frame;
  training: Training;
  ping: Ping;
}

/**
 * Sent if no other event was sent for 2 seconds. With ?acknowledge=1 it ends the events that are to
 * be acknowledged by POST /api/seen?viewer=V&number=N, and is repeated until they are.
 */
export interface Ping {
  /** The number of this viewer. */
  viewer?: number;
  /** The number of the events before this ping. */
  number?: number;
  /**
   * Seconds for which they have waited for news, from the acknowledgement of those before or the
   * start of the stream.
   */
  waited?: number;
}

/** The answer of each GET request, by its name. */
export interface Answers {
  state: State;
  scene: Scene | null;
  /** The answer to ?map=NAME&neuron=NUMBER. */
  neuron: NeuronAnswer;
  /** The answer to ?element=NUMBER. */
  taxel: TaxelAnswer;
  /** The strips of the current exploration; null without one. */
  strips: Strips | null;
}

/** The answer to a command or an acknowledgement. */
export interface Done {
  ok: true;
}

/** The answer to a refused command or question. */
export interface Refusal {
  /** A sentence. */
  error: string;
  /** The command was executed, but its change could not be saved. */
  unsaved?: true;
}

/** The source of the view, and the system that reads it. */
export interface State {
  version: 1;
  source: "recording" | "body";
  /** The name of the file or the body. */
  name: string;
  /** Those of the recording, or those that the body has completed, as far as they are kept. */
  explorations: ExplorationLabels[];
  /** The number of earlier explorations that are no longer kept. */
  dropped: number;
  /** Index of the current exploration; while a body explores, the index that it will have. */
  exploration: number | null;
  /**
   * The labels of the current exploration, with the names that viewers gave; while a body explores,
   * only what is known already.
   */
  labels: Labels;
  /** Index of the first frame of the current exploration that is kept. */
  first_frame: number;
  /** Index of the next frame. */
  frame: number;
  /** The number of frames of this exploration; null while a body explores it. */
  frames: number | null;
  /** The duration of this exploration in seconds; null while a body explores it. */
  duration: number | null;
  playing: boolean;
  /** 1: the original speed. */
  speed: number;
  /** Whether a body explores now. */
  live: boolean;
  channels: ChannelData[];
  /** Frames per second of each channel, by its name; 0 if unknown. */
  rates: Record<string, number>;
  /** The objects or materials that a body can explore; [] for a recording. */
  things: ThingData[];
  /** Name of the selected one. */
  thing: string | null;
  /** Offset of the selected object. */
  placement: Placement | null;
  systems: SystemChoice[];
  /** Name of the selected one. */
  system: string | null;
  /** A sentence: why there is no reading. */
  system_problem: string | null;
  graph: GraphData | null;
  maps: MapData[];
  /** The label that is predicted, such as "object". */
  label: string | null;
  /**
   * Whether the selected system learns a name that is given to an exploration: it is trained, one
   * of its maps answers, and the view teaches.
   */
  teaches: boolean;
  /**
   * The explorations that were taught to the selected system in this view, in the order of
   * learning; naming an exploration again replaces its entry.
   */
  taught: Taught[];
  /** Whether a system is being trained. */
  training: boolean;
  /** The number of complete rounds of a demonstration, or null. */
  demonstrated: number | null;
  naming: NamingState;
  /** The file of this session; null if its explorations are not saved. */
  saved: SavedFile | null;
  losses: Losses;
  /** Number of connected viewers. */
  clients: number;
  /**
   * Whether a real body moves only after the command explore: at the beginning, and after a fault.
   */
  awaits_start: boolean;
  /** A sentence: the last error. */
  problem: string | null;
}

/** The names of the explorations of this session, for the predicted label, or for "object". */
export interface NamingState {
  /**
   * The planned names, then the others in the order of their first use; the keys 1 to 9 of the page
   * give the first nine.
   */
  names: NameCount[];
  /** The planned number of explorations of each name; null without a plan. */
  each: number | null;
  /** The name that follows by the plan; null without a plan, or when it is fulfilled. */
  next: NextName | null;
  /**
   * The identifier of the current exploration, for the command `name`; null without one that is
   * kept. No other exploration of the session has it, also if this one is discarded.
   */
  id: number | null;
  /** The name that viewers gave to the current exploration; null without one. */
  given: string | null;
  /** The label that was given last and can be undone. */
  last: LastName | null;
}

/** A name, and the number of explorations of the session that have it. */
export interface NameCount {
  name: string;
  explorations: number;
}

/** The next exploration of a plan. */
export interface NextName {
  name: string;
  /** Its number among those of its name, from 1. */
  number: number;
}

/** A label that an exploration was given. */
export interface LastName {
  /** Its index. */
  exploration: number;
  /** Its identifier. */
  id: number;
  /** The name of the label. */
  label: string;
  /** Its value. */
  name: string;
}

/** The recording of a session, which is complete when the session ends. */
export interface SavedFile {
  /** Its name. */
  file: string;
  /** The number of explorations that are saved. */
  explorations: number;
}

/** The losses that the session has survived so far. */
export interface Losses {
  /** Explorations that failed. */
  failed: number;
  /** Explorations that could not be saved. */
  unsaved: number;
  /** Viewers whose connection has ended. */
  viewers: number;
}

/** An exploration of the recording or the body. */
export interface ExplorationLabels {
  index: number;
  /**
   * Its identifier. The index of a discarded exploration is that of the next one, the identifier is
   * not.
   */
  id: number;
  labels: Labels;
  /** The recording that contains it, if several are viewed. */
  recording?: string;
}

/**
 * An exploration that a system was taught by its name. Neurons that had a name before keep their
 * weights and their name.
 */
export interface Taught {
  /** Its index. */
  exploration: number;
  /** The given name. */
  name: string;
  /** Its reading before it was taught, perhaps "unknown". */
  before: string;
  /**
   * The neuron of the answering map whose weights are now exactly the input of this exploration;
   * null if the exploration had been read correctly and was only counted, or was not learned.
   */
  neuron: number | null;
  /** A sentence: why the system could not learn it. */
  problem: string | null;
}

/** Offset of an object from its usual place. */
export interface Placement {
  /** In mm. */
  x: number;
  /** In mm. */
  y: number;
  /** In degrees. */
  turn: number;
}

/** A system that can be selected. */
export interface SystemChoice {
  name: string;
  text: string;
  /** Whether it can be trained here. */
  learns: boolean;
}

/** A map of the selected system. */
export interface MapData {
  module: string;
  grid: GridData;
  classes: string[];
  neuron_classes: NeuronClasses;
}

/** x, y and z. */
export type Vector3 = [number, number, number];

/** In metres. */
export interface Camera {
  position: Vector3;
  target: Vector3;
}

/** The three-dimensional scene. Lengths are in metres, quaternions in the order w, x, y, z. */
export interface Scene {
  /** Names; a frame contains a pose for each. */
  bodies: string[];
  geoms: Geom[];
  camera: Camera;
}

/** A piece of the scene. */
export interface Geom {
  /** Index of the body with which it moves; -1: fixed. */
  body: number;
  name: string;
  type: "box" | "sphere" | "capsule" | "cylinder" | "ellipsoid" | "mesh";
  /** Half sizes in metres, as in MuJoCo: radius, half length, ... */
  size: Vector3;
  position: Vector3;
  quaternion: [number, number, number, number];
  /** Red, green, blue and opacity. */
  colour: [number, number, number, number];
  role: "hand" | "object" | "table";
  /** Element of the channel `touch`. */
  taxel: number | null;
  /** The vertices of a mesh: three numbers for each, in metres. */
  vertices?: number[];
  /** The faces of a mesh: three vertices for each. */
  faces?: number[];
}

/** A moment of an exploration. */
export interface Frame {
  exploration: number;
  /** Its index. */
  frame: number;
  /** The number of frames of the exploration; null while a body explores it. */
  frames: number | null;
  /** In seconds. */
  time: number;
  /** Whether it is the last of the exploration. */
  last: boolean;
  /**
   * The latest values by the name of the channel; for fast channels with one element the latest
   * 512.
   */
  channels: Record<string, NumberOrNull[]>;
  /** 7 for each body: x, y, z in metres, and the quaternion w, x, y, z; [] without a scene. */
  poses: NumberOrNull[];
  /** The outputs by the name of the module. */
  modules: Record<string, ModuleOutput>;
  /** By the name of the module. */
  maps: Record<string, MapActivity>;
  reading: Reading | null;
}

/** The output of a module: at most 4096 numbers, row-major in `shape`. */
export interface ModuleOutput {
  shape: number[];
  values: NumberOrNull[];
  /** Whether a larger output was summed over its leading axes. */
  folded: boolean;
}

/** The response of a map. */
export interface MapActivity {
  winner: number;
  /** The activity of each neuron, divided by the greatest: 0 to 1. */
  activity: NumberOrNull[];
}

/** The prediction of the system if this frame were the last. */
export interface Reading {
  /** The nearest class, or "unknown" if `novelty` is above 1. */
  answer: string;
  /** Relative distance margin to the second class: 0 for equal distances, at most 1. */
  confidence: NumberOrNull;
  /**
   * Distance from all that was learned, divided by the distance up to which a class is recognized;
   * null if the system has no threshold.
   */
  novelty: number | null;
  /** By distance, the nearest first. */
  candidates: Candidate[];
  /** The sensors that separate the nearest class from the next one; null without a next one. */
  contributions: ReadingContributions | null;
}

/**
 * The contributions of channels to the difference of the distances of two classes: positive where
 * the reading is more similar to the nearest class, negative where it is more similar to the other.
 */
export interface ReadingContributions {
  /** The next class. */
  other: string;
  /** The unit of the contributions; empty if they have that of no channel. */
  unit: string;
  /**
   * For each channel that the system reads the contribution of each element; null for an element
   * that it does not read.
   */
  channels: Record<string, NumberOrNull[]>;
}

/** A class, and the distance of its nearest neuron. */
export interface Candidate {
  name: string;
  distance: NumberOrNull;
}

/** The channels over an exploration: at each moment, or at evenly chosen moments. */
export interface Strips {
  exploration: number;
  /** The number of frames of the exploration; null while a body explores it. */
  frames: number | null;
  /** Index of each moment, as in its frame. */
  frame: number[];
  /** The time of each moment, in seconds. */
  time: number[];
  /** channel[moment][element]; without channels whose frames cover an interval. */
  channels: Record<string, NumberOrNull[][]>;
}

/** A map during training. */
export interface Training {
  system: string;
  /** The output map, also while modules before it learn. */
  module: string;
  step: number;
  steps: number;
  /** The radius of the neighbourhood, in neurons. */
  radius: number;
  learning_rate: number;
  /** The winners of the first 500 samples; [] before the map learns. */
  winners: SampleWinner[];
  /**
   * For each neuron the mean distance between its weights and those of its neighbours; [] before
   * the map learns.
   */
  u_matrix: number[];
  done: boolean;
}

/** The winner of a sample, and the class of the sample. */
export interface SampleWinner {
  sample: number;
  winner: number;
  class: string;
}

/** The class and the weights of a neuron. */
export interface NeuronAnswer {
  map: string;
  neuron: number;
  /** Its class. */
  answer: string | null;
  /** Only values[0]: that of this neuron. */
  planes: ChannelPlanes[];
  /** The 10 nearest explorations among the first 2000, by distance. */
  nearest: NearExploration[];
}

/** An exploration, and the distance of its input vector from the weights of a neuron. */
export interface NearExploration {
  exploration: number;
  labels: Labels;
  distance: number;
}

/** The weights of an element of the channel `touch`. */
export interface TaxelAnswer {
  element: number;
  name: string;
  /** For each map, by its module, the weight of each neuron for this element. */
  maps: Record<string, number[]>;
}

/** A command of the page. */
export type Command =
  | PlainCommand
  | StepCommand
  | SeekCommand
  | SpeedCommand
  | ThingCommand
  | PlacementCommand
  | NameCommand
  | UndoNameCommand
  | PlanCommand
  | SystemCommand;

/**
 * A command without fields. `explore` starts an exploration of a body with the selected thing,
 * `dismiss` removes the problem from the state.
 */
export interface PlainCommand {
  command: "play" | "pause" | "explore" | "train" | "stop_training" | "dismiss";
}

/** Pauses, and moves by a number of frames. */
export interface StepCommand {
  command: "step";
  /** Negative: back. */
  frames: number;
}

/** Moves to a frame. */
export interface SeekCommand {
  command: "seek";
  exploration: number;
  frame: number;
}

/** Sets the speed. */
export interface SpeedCommand {
  command: "speed";
  speed: number;
}

/** Selects what a body explores next. */
export interface ThingCommand {
  command: "thing";
  name: string;
}

/** Sets the offset of the next object of a hand. */
export interface PlacementCommand {
  command: "placement";
  /** In mm. */
  x: number;
  /** In mm. */
  y: number;
  /** In degrees. */
  turn: number;
}

/** Gives an exploration a label, such as the name of what is touched. */
export interface NameCommand {
  command: "name";
  /** The name of the label, such as "object". */
  label: string;
  /** Its value; at most 255 bytes, without line breaks, not empty. */
  value: string;
  /**
   * The identifier of the exploration, which is refused if it was discarded; without it, the
   * current exploration.
   */
  id?: number;
}

/** Takes back the name that was given last; refused if that is another one now. */
export interface UndoNameCommand {
  command: "undo_name";
  /** The identifier of the exploration that was named last. */
  id: number;
  /** The name of the label. */
  label: string;
  /** The value that is taken back. */
  value: string;
}

/** Plans so many explorations of each name. */
export interface PlanCommand {
  command: "plan";
  /** 0 ends the plan. */
  each: number;
}

/** Selects the system for the reading. */
export interface SystemCommand {
  command: "system";
  name: string;
}
