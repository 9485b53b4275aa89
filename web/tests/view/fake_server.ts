// Speaks the protocol of src/view/data.ts without a body or a system: it plays made-up frames, notes
// every command, and can stall, vanish and come back when a test requires it.

import { readFile } from "node:fs/promises";
import { createServer, type IncomingMessage, type Server, type ServerResponse } from "node:http";
import type { AddressInfo, Socket } from "node:net";
import { join } from "node:path";

import type { Command, NeuronAnswer, Scene, State, TaxelAnswer } from "../../src/view/data";
import { fakeFrame, fakeState, fakeStrips, fakeTraining, kFrames, kRate, sceneOf } from "./fake_frames";
import { kTaxels } from "./fake_hand";

const kPolicy =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
const kTypes: Record<string, string> = {
  html: "text/html; charset=utf-8",
  js: "text/javascript; charset=utf-8",
  css: "text/css; charset=utf-8",
};

export class FakeServer {
  readonly commands: Command[] = [];
  readonly seen: string[] = []; // the acknowledgements, as "viewer:number"
  readonly token = "a-token-of-the-tests";
  refusal: string | null = null; // what every command is answered with
  silent = false; // no pings
  private readonly clients = new Set<ServerResponse>();
  private readonly sockets = new Set<Socket>();
  private server: Server | null = null;
  private port = 0;
  private playing: NodeJS.Timeout | undefined;
  private pings: NodeJS.Timeout | undefined;
  private frame = { exploration: 0, frame: 0 };
  private sceneNow: Scene | null;

  constructor(
    private readonly folder: string,
    public state: State = fakeState(),
    scene?: Scene | null,
  ) {
    this.sceneNow = scene === undefined ? sceneOf(0) : scene;
  }

  get address(): string {
    return `http://127.0.0.1:${this.port}/?token=${this.token}`;
  }

  async start(): Promise<void> {
    const server = createServer((request, response) => void this.answer(request, response));
    server.on("connection", (socket) => {
      this.sockets.add(socket);
      socket.on("close", () => this.sockets.delete(socket));
    });
    await new Promise<void>((done) => server.listen(this.port, "127.0.0.1", done));
    this.port = (server.address() as AddressInfo).port;
    this.server = server;
    this.pings = setInterval(() => this.silent || this.send("ping", {}), 2000);
  }

  /** As if the program had ended. */
  async stop(): Promise<void> {
    clearInterval(this.pings);
    clearInterval(this.playing);
    this.clients.clear();
    for (const socket of this.sockets) socket.destroy();
    await new Promise<void>((done) => (this.server === null ? done() : this.server.close(() => done())));
  }

  change(part: Partial<State>): void {
    this.state = { ...this.state, ...part };
    this.send("state", this.state);
  }

  show(exploration: number, frame: number): void {
    if (exploration !== this.frame.exploration && this.sceneNow !== null) this.setScene(sceneOf(exploration));
    this.frame = { exploration, frame };
    this.send("frame", fakeFrame(exploration, frame));
  }

  /** As show(), with elements of the touch sensors missing. */
  showWithout(exploration: number, frame: number, missing: readonly number[]): void {
    const shown = fakeFrame(exploration, frame);
    const touch = shown.channels["touch"]!.map((value, i) => (missing.includes(i) ? null : value));
    this.frame = { exploration, frame };
    this.send("frame", { ...shown, channels: { ...shown.channels, touch } });
  }

  setScene(scene: Scene | null): void {
    this.sceneNow = scene;
    this.send("scene", scene);
  }

  send(event: string, data: unknown): void {
    const text = `event: ${event}\ndata: ${JSON.stringify(data)}\n\n`;
    for (const client of this.clients) client.write(text);
  }

  /** So many frames at so many a second; done when all are sent. */
  async flood(count: number, rate: number): Promise<void> {
    for (let i = 0; i < count; i += 1) {
      this.show(0, i % kFrames);
      if (i % 5 === 4) await new Promise((done) => setTimeout(done, 5000 / rate));
    }
  }

  private async answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const url = new URL(request.url ?? "/", "http://127.0.0.1");
    response.setHeader("Content-Security-Policy", kPolicy);
    if (!url.pathname.startsWith("/api/")) return this.file(url.pathname, response);
    const token = request.headers["x-somato-token"] ?? url.searchParams.get("token");
    if (token !== this.token) return json(response, 401, { error: "The token is missing or wrong" });
    if (url.pathname === "/api/events") return this.listen(response);
    if (url.pathname === "/api/state") return json(response, 200, this.state);
    if (url.pathname === "/api/scene") return json(response, 200, this.sceneNow);
    if (url.pathname === "/api/strips") return json(response, 200, fakeStrips(this.frame.exploration));
    if (url.pathname === "/api/neuron")
      return json(response, 200, this.neuron(Number(url.searchParams.get("neuron"))));
    if (url.pathname === "/api/taxel")
      return json(response, 200, taxel(Number(url.searchParams.get("element"))));
    if (url.pathname === "/api/recording") return void response.end("a recording");
    if (url.pathname === "/api/system") return void response.end("a system");
    if (url.pathname === "/api/seen") {
      this.seen.push(`${url.searchParams.get("viewer")}:${url.searchParams.get("number")}`);
      return json(response, 200, { ok: true });
    }
    if (url.pathname === "/api/command") return this.take(await body(request), response);
    json(response, 404, { error: "Not found" });
  }

  private async file(path: string, response: ServerResponse): Promise<void> {
    const name = path === "/" ? "view.html" : path.slice(1);
    if (!/^view\.(html|js|css)$/.test(name)) return json(response, 404, { error: "Not found" });
    response.writeHead(200, { "Content-Type": kTypes[name.split(".")[1]!] });
    response.end(await readFile(join(this.folder, name)));
  }

  private listen(response: ServerResponse): void {
    response.writeHead(200, { "Content-Type": "text/event-stream", "Cache-Control": "no-store" });
    this.clients.add(response);
    response.on("close", () => this.clients.delete(response));
    response.write(`event: state\ndata: ${JSON.stringify(this.state)}\n\n`);
    if (this.state.explorations.length > 0)
      response.write(
        `event: frame\ndata: ${JSON.stringify(fakeFrame(this.frame.exploration, this.frame.frame))}\n\n`,
      );
    response.write("event: ping\ndata: {}\n\n");
  }

  private take(text: string, response: ServerResponse): void {
    const command = JSON.parse(text) as Command;
    this.commands.push(command);
    if (this.refusal !== null) return json(response, 400, { error: this.refusal });
    this.obey(command);
    // The state that follows from a name may arrive before the answer.
    setTimeout(() => json(response, 200, { ok: true }), command.command === "name" ? 100 : 0);
  }

  private obey(command: Command): void {
    const { exploration, frame } = this.frame;
    if (command.command === "play") this.play();
    if (command.command === "pause") this.pause();
    if (command.command === "step") this.go(exploration, frame + command.frames);
    if (command.command === "seek") this.go(command.exploration, command.frame);
    if (command.command === "speed") this.change({ speed: command.speed });
    if (command.command === "system") this.change({ system: command.name });
    if (command.command === "thing") this.change({ thing: command.name });
    if (command.command === "placement")
      this.change({ placement: { x: command.x, y: command.y, turn: command.turn } });
    if (command.command === "train") this.train();
    if (command.command === "name" && this.state.teaches) this.learn(command.value);
    if (command.command === "stop_training") this.change({ training: false });
  }

  private go(exploration: number, frame: number): void {
    const place = Math.min(kFrames - 1, Math.max(0, frame));
    this.show(exploration, place);
    this.change({ exploration, frame: place + 1 });
  }

  private play(): void {
    clearInterval(this.playing);
    this.change({ playing: true });
    this.playing = setInterval(
      () => {
        this.show(this.frame.exploration, this.frame.frame + 1);
        if (this.frame.frame >= kFrames - 1) this.pause();
      },
      1000 / kRate / this.state.speed,
    );
  }

  private pause(): void {
    clearInterval(this.playing);
    this.change({ playing: false, frame: this.frame.frame + 1 });
  }

  private learn(name: string): void {
    const one = { exploration: this.frame.exploration, name, before: "unknown", neuron: 17, problem: null };
    this.change({ taught: [...this.state.taught, one] });
  }

  private train(): void {
    this.change({ training: true });
    let step = 0;
    const timer = setInterval(() => {
      step = Math.min(950, step + 50); // the end is left to the page, which may be slow
      this.send("training", fakeTraining(step, 1000));
      if (this.state.training && this.clients.size > 0) return;
      clearInterval(timer);
      this.change({ training: false });
    }, 60);
  }

  private neuron(neuron: number): NeuronAnswer {
    const map = this.state.maps[0]!;
    const number = map.neuron_classes[neuron] ?? null;
    const nearest = [0, 1, 2].map((index) => ({
      ...this.state.explorations[(neuron + index) % 6]!,
      distance: 0.1 + index / 8,
    }));
    return {
      map: map.module,
      neuron,
      answer: number === null ? null : map.classes[number]!,
      planes: this.state.channels.slice(2, 4).map((channel) => ({
        channel,
        unit: "",
        values: [channel.elements.map((_, i) => ((i * 3 + neuron) % 10) / 10)],
      })),
      nearest: nearest.map(({ index, labels, distance }) => ({ exploration: index, labels, distance })),
    };
  }
}

function taxel(element: number): TaxelAnswer {
  return {
    element,
    name: kTaxels[element] ?? "?",
    maps: { map: Array.from({ length: 225 }, (_, i) => ((i * 7 + element) % 50) / 50) },
  };
}

function json(response: ServerResponse, status: number, data: unknown): void {
  response.writeHead(status, { "Content-Type": "application/json" });
  response.end(JSON.stringify(data));
}

async function body(request: IncomingMessage): Promise<string> {
  let text = "";
  for await (const part of request) text += String(part);
  return text;
}
