// The stream of events and its state: it is lost if the browser reports an error or if no event has
// arrived for some seconds. It is then reconnected every few seconds, or on request. Each ping is
// acknowledged, because the program sends the next events only after that: they are the latest ones,
// whatever is stored on the way.

import type { Events, Ping, Scene, State } from "../data";
import type { Freshness } from "./freshness";
import type { Server } from "./server";

export type Link =
  | { kind: "connecting" }
  | { kind: "open" }
  | { kind: "lost"; seconds: number; full: boolean } // until the next attempt; full: too many viewers
  | { kind: "refused" }; // the token is invalid

export interface Listener {
  link(link: Link): void;
  state(state: State): void;
  scene(scene: Scene | null): void;
  frame(text: string): void; // not parsed: most frames may be dropped
  training(text: string): void;
  received(): void; // all events that were sent together
}

const silence = 6500; // ms
const longestSilence = 60_000; // ms, on a line on which an event takes that long
const pause = 3; // s

export class Connection {
  private events: EventSource | null = null;
  private silent = 0;
  private countdown = 0;
  private full = false;
  private known = false; // whether the scene was received or requested since connecting
  private patience = silence;
  private acknowledging = 0; // the number that is on its way
  private end = new AbortController(); // of the requests of this stream

  constructor(
    private readonly server: Server,
    private readonly freshness: Freshness,
    private readonly listener: Listener,
  ) {}

  open(): void {
    this.close();
    this.listener.link({ kind: "connecting" });
    this.end = new AbortController();
    this.acknowledging = 0;
    this.freshness.begin(performance.now());
    this.known = false;
    const events = this.server.events();
    this.events = events;
    events.onerror = () => void this.lose();
    events.onopen = () => this.listener.link({ kind: "open" });
    this.listen(events);
    this.restartTimeout();
  }

  close(): void {
    this.events?.close();
    this.events = null;
    this.end.abort(); // a line that answers no more must not collect requests
    window.clearTimeout(this.silent);
    window.clearInterval(this.countdown);
  }

  private listen(events: EventSource): void {
    const on = (name: keyof Events, take: (text: string) => void) =>
      events.addEventListener(name, (event: MessageEvent<string>) => {
        this.restartTimeout();
        take(event.data);
      });
    on("state", (text) => this.listener.state(JSON.parse(text) as Events["state"]));
    on("scene", (text) => this.tellScene(JSON.parse(text) as Events["scene"]));
    on("frame", (text) => this.listener.frame(text));
    on("training", (text) => this.listener.training(text));
    on("ping", (text) => this.answer(JSON.parse(text) as Events["ping"]));
  }

  private answer(ping: Ping): void {
    if (!this.known) void this.askScene();
    if (ping.viewer !== undefined && ping.number !== undefined) {
      this.freshness.receive(ping.number, ping.waited ?? 0, performance.now());
      void this.acknowledge(ping.viewer, ping.number);
    }
    this.listener.received();
  }

  /** One that is lost on the way is sent again with the next ping. */
  private async acknowledge(viewer: number, number: number): Promise<void> {
    if (this.acknowledging === number) return;
    this.acknowledging = number;
    try {
      await this.server.seen(viewer, number, this.end.signal);
    } catch {
      // The end of the stream reports the error.
    } finally {
      if (this.acknowledging === number) this.acknowledging = 0;
    }
  }

  /** The program may have none, and then sends none. */
  private async askScene(): Promise<void> {
    this.known = true;
    try {
      this.listener.scene(await this.server.scene());
    } catch {
      // The end of the stream reports the error.
    }
  }

  private tellScene(scene: Scene | null): void {
    this.known = true;
    this.listener.scene(scene);
  }

  private restartTimeout(): void {
    window.clearTimeout(this.silent);
    this.silent = window.setTimeout(() => this.tire(), this.patience);
  }

  /** A slow line may need longer for an event: the next attempt has more patience. */
  private tire(): void {
    this.patience = Math.min(longestSilence, 2 * this.patience);
    void this.lose();
  }

  private async lose(): Promise<void> {
    this.close();
    this.full = false;
    this.wait(pause);
    const status = await this.server.status(1000 * pause);
    this.full = status === 503;
    if (status !== 401 && status !== 403) return;
    this.close();
    this.listener.link({ kind: "refused" });
  }

  private wait(seconds: number): void {
    let left = seconds;
    const report = () => this.listener.link({ kind: "lost", seconds: left, full: this.full });
    report();
    this.countdown = window.setInterval(() => {
      left -= 1;
      if (left <= 0) this.open();
      else report();
    }, 1000);
  }
}
