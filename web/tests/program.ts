// Runs the program as somebody at a terminal does. The tests do not stand still meanwhile: vitest gives up a process
// that does not answer for a minute.

import { execFile } from "node:child_process";
import { promisify } from "node:util";

const run = promisify(execFile);

/** Runs the program and returns its output. The promise is rejected with its messages if it fails. */
export async function somato(words: string[], options: { cwd?: string; env?: NodeJS.ProcessEnv } = {}): Promise<string> {
  const program = process.env["SOMATO_PROGRAM"];
  if (program === undefined) throw new Error("SOMATO_PROGRAM does not say where the program is");
  return output(program, words, options);
}

export async function output(program: string, words: string[], options: object = {}): Promise<string> {
  const { stdout } = await run(program, words, { ...options, encoding: "utf8", maxBuffer: 1 << 30 });
  return stdout;
}
