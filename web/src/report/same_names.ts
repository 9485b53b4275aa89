// Systems of one name from several files, told apart by where their files are: the folder, or the
// whole path where folders have one name, too.

import type { ClaimReport, SystemReport } from "./data";

/** The same, with `place` where it is needed. */
export function withPlaces(
  systems: SystemReport[],
  claims: ClaimReport[],
): { systems: SystemReport[]; claims: ClaimReport[] } {
  const twice = filesWithTwins(systems);
  const folders = twice.map(folderOf);
  const isTold = new Set(folders).size === folders.length && !folders.includes("");
  const places = new Map(twice.map((file, i) => [file, isTold ? (folders[i] ?? file) : file]));
  const placed = <One extends { file: string }>(one: One): One => {
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
