// Systems of the same name from several files are distinguished by the folder of their files, or
// by the whole path if the folders have the same name, too.

import type { ClaimReport, SystemReport } from "./unpacked";

/** `place` distinguishes it from one of the same name; it is found here, not in the report's JSON. */
export type Placed<One> = One & { place?: string };

/** The same, with `place` if needed. */
export function withPlaces(
  systems: SystemReport[],
  claims: ClaimReport[],
): { systems: Placed<SystemReport>[]; claims: Placed<ClaimReport>[] } {
  const twice = filesWithTwins(systems);
  const folders = twice.map(folderOf);
  const isTold = new Set(folders).size === folders.length && !folders.includes("");
  const places = new Map(twice.map((file, i) => [file, isTold ? (folders[i] ?? file) : file]));
  const placed = <One extends { file: string }>(one: One): Placed<One> => {
    const place = places.get(one.file);
    return place === undefined ? one : { ...one, place };
  };
  return { systems: systems.map(placed), claims: claims.map(placed) };
}

function filesWithTwins(systems: SystemReport[]): string[] {
  const files = new Map<string, Set<string>>();
  for (const { name, variation, question, file } of systems) {
    const key = JSON.stringify([name, variation, question]);
    files.set(key, (files.get(key) ?? new Set()).add(file));
  }
  return [...new Set([...files.values()].filter(({ size }) => size > 1).flatMap((all) => [...all]))];
}

function folderOf(file: string): string {
  return file.split("/").at(-2) ?? "";
}
