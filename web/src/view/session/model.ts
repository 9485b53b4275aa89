// The state of the page and its requests to the program. Panels observe and change the model, and
// are independent of each other.

import type { ChannelData } from "../../parts/data";
import type { Link, Listener } from "./connection";
import type { Command, Frame, NeuronAnswer, Scene, State, TaxelAnswer, Training } from "../data";
import { DrawingBudget } from "./drawing_budget";
import { Freshness } from "./freshness";
import { ForceScale } from "../scene/force_scale";
import { History } from "../strips/history";
import { HistorySource } from "../strips/history_source";
import { Observable } from "./observable";
import { Refused, type Server } from "./server";

/** The clicked element and its answer, which is null until it arrives. */
export type Question =
  | { about: "neuron"; map: string; neuron: number; answer: NeuronAnswer | null }
  | { about: "taxel"; element: number; answer: TaxelAnswer | null };

/** Whether a command was executed, and its change saved. */
export type Answer = "done" | "unsaved" | "refused";

type Source = Pick<Listener, "link" | "state" | "scene">;

export class Model implements Source {
  readonly shownState = new Observable<State | null>(null);
  readonly shownScene = new Observable<Scene | null>(null);
  readonly sceneKnown = new Observable(false);
  readonly frame = new Observable<Frame | null>(null);
  readonly training = new Observable<Training | null>(null);
  readonly shownLink = new Observable<Link>({ kind: "connecting" });
  readonly problem = new Observable<string | null>(null);
  readonly question = new Observable<Question | null>(null);
  readonly pointed = new Observable<{ time: number } | null>(null); // in a strip, s
  readonly module = new Observable<string | null>(null);
  readonly map = new Observable<string | null>(null);
  readonly explains = new Observable(false); // whether skins show contributions
  readonly theme = new Observable(0); // set when the colours have changed
  readonly history = new History();
  readonly scale = new ForceScale();
  readonly budget = new DrawingBudget();
  readonly freshness = new Freshness();
  private readonly source: HistorySource;

  constructor(private readonly server: Server) {
    this.source = new HistorySource(server, this.history, () => this.recall());
  }

  link(link: Link): void {
    if (link.kind === "open") this.history.clear(); // it may have continued meanwhile
    this.shownLink.set(link);
  }

  state(sent: State): void {
    const state = { ...sent, channels: sent.channels.map(named) };
    const before = this.shownState.value;
    if (state.problem !== (before?.problem ?? null)) this.problem.set(state.problem);
    if (before?.name !== state.name) this.history.clear();
    this.keepChoices(state);
    this.scale.unit = state.channels.find(({ name }) => name === "touch")?.unit ?? "";
    this.shownState.set(state);
    if (before !== null && before.system !== state.system) this.forget();
  }

  scene(scene: Scene | null): void {
    this.sceneKnown.set(true);
    this.shownScene.set(scene);
  }

  /** Whether a body is drawn, or may come: then the skin is beside it. */
  get hasBody(): boolean {
    return this.shownScene.value !== null || !this.sceneKnown.value;
  }

  draw(frame: Frame): void {
    this.history.add(frame);
    this.scale.see(frame.exploration, frame.channels["touch"] ?? []);
    this.frame.set(frame);
    this.source.look();
  }

  /** The visible range has grown. */
  private recall(): void {
    const frame = this.frame.value;
    if (frame === null) return;
    for (const touch of this.history.rows("touch")) this.scale.see(frame.exploration, touch);
    this.frame.set(frame);
  }

  /** The problem is closed, in all pages. */
  async dismiss(): Promise<void> {
    const isShared = this.shownState.value?.problem !== null;
    this.problem.set(null);
    if (isShared) await this.send({ command: "dismiss" });
  }

  /** Sends a command; a problem is shown. */
  async send(command: Command): Promise<Answer> {
    try {
      await this.server.command(command);
      return "done";
    } catch (problem) {
      this.problem.set(sentenceOf(problem));
      return problem instanceof Refused && problem.isUnsaved ? "unsaved" : "refused";
    }
  }

  async file(name: "recording" | "system"): Promise<Blob | null> {
    try {
      return await this.server.file(name);
    } catch (problem) {
      this.problem.set(sentenceOf(problem));
      return null;
    }
  }

  async askNeuron(map: string, neuron: number): Promise<void> {
    const question: Question = { about: "neuron", map, neuron, answer: null };
    await this.answer(question, async () => ({ ...question, answer: await this.server.neuron(map, neuron) }));
  }

  async askTaxel(element: number): Promise<void> {
    const question: Question = { about: "taxel", element, answer: null };
    await this.answer(question, async () => ({ ...question, answer: await this.server.taxel(element) }));
  }

  /** An answer that arrives after the next request is discarded. */
  private async answer(question: Question, answer: () => Promise<Question>): Promise<void> {
    this.question.set(question);
    try {
      const answered = await answer();
      if (this.question.value === question) this.question.set(answered);
    } catch (problem) {
      if (this.question.value === question) this.question.set(null);
      this.problem.set(sentenceOf(problem));
    }
  }

  private keepChoices(state: State): void {
    const maps = state.maps.map((map) => map.module);
    if (!maps.includes(this.map.value ?? "")) this.map.set(this.preferredMap(state, maps));
    const modules = state.graph?.modules.map((module) => module.name) ?? [];
    if (!modules.includes(this.module.value ?? "")) this.module.set(preferredModule(state));
  }

  private preferredMap(state: State, maps: string[]): string | null {
    const answering = state.graph?.map ?? "";
    return maps.includes(answering) ? answering : (maps[0] ?? null);
  }

  /** Answers of another system are discarded. */
  private forget(): void {
    this.question.set(null);
    this.training.set(null);
  }
}

/** The number of elements of a channel may be unknown before its first frame. */
function named(channel: ChannelData): ChannelData {
  if (channel.elements.length > 0) return channel;
  const count = Math.max(
    1,
    channel.shape.reduce((product, size) => product * size, 1),
  );
  return { ...channel, elements: Array.from({ length: count }, (_, i) => String(i + 1)) };
}

/** The input of the answering map, before it is normalized. */
function preferredModule(state: State): string | null {
  const modules = state.graph?.modules ?? [];
  const find = (name: string | undefined) => modules.find((module) => module.name === name);
  let code = find(find(state.graph?.map)?.inputs[0]?.module);
  if (code?.type === "normalization") code = find(code.inputs[0]?.module) ?? code;
  return (code ?? modules[0])?.name ?? null;
}

function sentenceOf(problem: unknown): string {
  if (problem instanceof Refused) return problem.message;
  return "The program did not respond; the command was not executed";
}
