// What the page asks of the program and tells it to do.

import type { Command, NeuronAnswer, Scene, Strips, TaxelAnswer } from "./data";

/** What went wrong, in a sentence that may stand on the page. */
export class Refused extends Error {
  constructor(
    message: string,
    readonly status: number,
  ) {
    super(message);
  }
}

export class Server {
  constructor(private readonly token: string) {}

  events(): EventSource {
    return new EventSource(`api/events?token=${encodeURIComponent(this.token)}`);
  }

  /** How the stream of events is answered: 200, another status, or 0 where nobody answers. */
  async status(): Promise<number> {
    const end = new AbortController();
    try {
      return (await this.fetch("api/events", { signal: end.signal })).status;
    } catch {
      return 0;
    } finally {
      end.abort();
    }
  }

  scene(): Promise<Scene | null> {
    return this.get<Scene | null>("api/scene");
  }

  strips(): Promise<Strips | null> {
    return this.get<Strips | null>("api/strips");
  }

  neuron(map: string, neuron: number): Promise<NeuronAnswer> {
    return this.get(`api/neuron?map=${encodeURIComponent(map)}&neuron=${neuron}`);
  }

  taxel(element: number): Promise<TaxelAnswer> {
    return this.get(`api/taxel?element=${element}`);
  }

  async command(command: Command): Promise<void> {
    const headers = { "Content-Type": "application/json" };
    const body = JSON.stringify(command);
    await answerOf(await this.fetch("api/command", { method: "POST", headers, body }));
  }

  private async get<T>(path: string): Promise<T> {
    return (await answerOf(await this.fetch(path, {}))) as T;
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
  throw new Refused(problem ?? `The program answered with ${response.status}`, response.status);
}

function problemOf(answer: unknown): string | null {
  if (typeof answer !== "object" || answer === null || !("error" in answer)) return null;
  return typeof answer.error === "string" ? answer.error : "The program refused";
}
