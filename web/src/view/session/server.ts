// Requests and commands from the page to the program.

import type { Answers, Command, NeuronAnswer, Refusal, Scene, Strips, TaxelAnswer } from "../data";

/** An error, with a message for the page. */
export class Refused extends Error {
  constructor(
    message: string,
    readonly status: number,
    readonly isUnsaved = false, // the command was executed, but its change could not be saved
  ) {
    super(message);
  }
}

export class Server {
  constructor(private readonly token: string) {}

  events(): EventSource {
    return new EventSource(`api/events?acknowledge=1&token=${encodeURIComponent(this.token)}`);
  }

  /** Acknowledges the events with this number. */
  async seen(viewer: number, number: number, signal: AbortSignal): Promise<void> {
    const path = `api/seen?viewer=${viewer}&number=${number}`;
    await answerOf(await this.fetch(path, { method: "POST", signal }));
  }

  /** The HTTP status of the stream of events, or 0 without a response within the patience in ms. */
  async status(patience: number): Promise<number> {
    const end = new AbortController();
    const impatience = window.setTimeout(() => end.abort(), patience);
    try {
      return (await this.fetch("api/events", { signal: end.signal })).status;
    } catch {
      return 0;
    } finally {
      window.clearTimeout(impatience);
      end.abort();
    }
  }

  scene(): Promise<Scene | null> {
    return this.get("scene");
  }

  strips(): Promise<Strips | null> {
    return this.get("strips");
  }

  neuron(map: string, neuron: number): Promise<NeuronAnswer> {
    return this.get("neuron", `?map=${encodeURIComponent(map)}&neuron=${neuron}`);
  }

  taxel(element: number): Promise<TaxelAnswer> {
    return this.get("taxel", `?element=${element}`);
  }

  async command(command: Command): Promise<void> {
    const headers = { "Content-Type": "application/json" };
    const body = JSON.stringify(command);
    await answerOf(await this.fetch("api/command", { method: "POST", headers, body }));
  }

  /** The recording of the session, or the selected system. */
  async file(name: "recording" | "system"): Promise<Blob> {
    const response = await this.fetch(`api/${name}`, {});
    return response.ok ? response.blob() : ((await answerOf(response)) as never);
  }

  private async get<Name extends keyof Answers>(name: Name, query = ""): Promise<Answers[Name]> {
    return (await answerOf(await this.fetch(`api/${name}${query}`, {}))) as Answers[Name];
  }

  private fetch(path: string, options: RequestInit): Promise<Response> {
    const headers = { ...options.headers, "X-Somato-Token": this.token };
    return fetch(path, { ...options, headers, cache: "no-store" });
  }
}

async function answerOf(response: Response): Promise<unknown> {
  const answer: unknown = await response.json().catch(() => undefined);
  const problem = problemOf(answer);
  if (response.ok && problem === null && answer !== undefined) return answer;
  const words = problem ?? `The program responded with status ${response.status}`;
  throw new Refused(words, response.status, problem !== null && (answer as Partial<Refusal>).unsaved === true);
}

function problemOf(answer: unknown): string | null {
  if (typeof answer !== "object" || answer === null || !("error" in answer)) return null;
  return typeof answer.error === "string" ? answer.error : "The program refused the command";
}
