// The line between the page and the program, without a browser: acknowledgements, and the age of what is shown.

import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { Connection, type Link } from "../../src/view/session/connection";
import { Freshness } from "../../src/view/session/freshness";
import type { Server } from "../../src/view/session/server";

type Take = (event: { data: string }) => void;

/** A stream of events in the hands of a test. */
class FakeStream {
  onopen: (() => void) | null = null;
  onerror: (() => void) | null = null;
  isClosed = false;
  private readonly takes = new Map<string, Take>();

  addEventListener(name: string, take: Take): void {
    this.takes.set(name, take);
  }

  close(): void {
    this.isClosed = true;
  }

  send(name: string, data: unknown): void {
    this.takes.get(name)!({ data: JSON.stringify(data) });
  }
}

class FakeProgram {
  readonly streams: FakeStream[] = [];
  readonly seen: [number, number][] = [];
  readonly signals: AbortSignal[] = [];
  scenes = 0;
  answers = true; // otherwise requests stay open

  get stream(): FakeStream {
    return this.streams.at(-1)!;
  }

  asServer(): Server {
    const pending = () => (this.answers ? Promise.resolve() : new Promise<void>(() => undefined));
    const server = {
      events: () => (this.streams.push(new FakeStream()), this.stream),
      scene: () => {
        this.scenes += 1;
        return Promise.resolve(null);
      },
      status: () => Promise.resolve(0),
      seen: (viewer: number, number: number, signal: AbortSignal) => {
        this.seen.push([viewer, number]);
        this.signals.push(signal);
        return pending();
      },
    };
    return server as unknown as Server;
  }
}

const ping = (number: number, waited = 0) => ({ viewer: 3, number, waited });

let program: FakeProgram;
let freshness: Freshness;
let links: Link["kind"][];
let received: number;
let connection: Connection;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("window", globalThis);
  program = new FakeProgram();
  freshness = new Freshness();
  links = [];
  received = 0;
  const nothing = () => undefined;
  connection = new Connection(program.asServer(), freshness, {
    link: ({ kind }) => void links.push(kind),
    state: nothing,
    scene: nothing,
    frame: nothing,
    training: nothing,
    received: () => void (received += 1),
  });
  connection.open();
});

afterEach(() => {
  connection.close();
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

test("the events before a ping are acknowledged once, and again if that was lost", async () => {
  program.stream.send("frame", {});
  expect(program.seen).toEqual([]);
  program.stream.send("ping", ping(1));
  program.answers = false;
  await vi.advanceTimersByTimeAsync(0);
  program.stream.send("ping", ping(1)); // the first attempt has failed on the way
  program.stream.send("ping", ping(1)); // the second is under way
  program.stream.send("ping", ping(2)); // so it has arrived, though its answer has not
  expect(program.seen).toEqual([
    [3, 1],
    [3, 1],
    [3, 2],
  ]);
  expect(received).toBe(4);
});

test("a server that asks for no acknowledgement gets none", () => {
  program.stream.send("ping", {});
  expect(program.seen).toEqual([]);
});

test("the scene is requested only if it was not among the first events", () => {
  program.stream.send("scene", null);
  program.stream.send("ping", ping(1));
  expect(program.scenes).toBe(0);
  connection.open();
  program.stream.send("ping", ping(1));
  program.stream.send("ping", ping(2));
  expect(program.scenes).toBe(1);
});

test("a dead line collects no requests", () => {
  program.answers = false;
  for (let i = 0; i < 50; i += 1) {
    connection.open();
    program.stream.send("ping", ping(1));
  }
  expect(program.seen.length).toBe(50);
  expect(program.signals.filter((signal) => !signal.aborted).length).toBe(1);
  expect(program.streams.filter((stream) => !stream.isClosed).length).toBe(1);
});

test("a line on which an event takes long is given longer with each attempt", async () => {
  const attempts = async (time: number) => {
    const before = program.streams.length;
    await vi.advanceTimersByTimeAsync(time);
    return program.streams.length - before;
  };
  expect(await attempts(6400)).toBe(0);
  expect(await attempts(100 + 3000)).toBe(1);
  expect(await attempts(12_900)).toBe(0);
  expect(await attempts(100 + 3000)).toBe(1);
  expect(links).toContain("lost");
});

test("the age of what is shown counts from when it was the latest, by the clock of the browser", () => {
  const fresh = new Freshness();
  expect(fresh.age(500)).toBe(0);
  fresh.begin(1000);
  fresh.receive(1, 0.2, 1500); // sent at 1200 or later
  fresh.show();
  expect(fresh.age(1500)).toBe(300);
  fresh.receive(2, 0, 5500); // four seconds under way, since the acknowledgement at 1500
  expect(fresh.age(5500)).toBe(4300); // not drawn yet
  fresh.show();
  expect(fresh.age(5500)).toBe(4000);
  fresh.receive(2, 0, 6000); // repeated: nothing newer
  fresh.show();
  expect(fresh.age(6000)).toBe(4500);
  fresh.receive(3, 0.5, 6100);
  fresh.show();
  expect(fresh.age(6100)).toBe(100);
});

test("the age continues to grow when the line is lost and another is opened", () => {
  const fresh = new Freshness();
  fresh.begin(0);
  fresh.receive(1, 0, 10);
  fresh.show();
  fresh.begin(5000);
  fresh.show();
  expect(fresh.age(6000)).toBe(6000);
  fresh.receive(1, 0.1, 6000); // the first of the new stream
  fresh.show();
  expect(fresh.age(6000)).toBe(900);
});
