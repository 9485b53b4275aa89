// An exploration in a few words.

/** "boule, trial 2"; what it was made with where nobody named an object. */
export function describe(labels: Record<string, string>): string {
  const { object, trial } = labels;
  const first = object ?? Object.values(labels)[0] ?? "";
  if (trial === undefined) return first;
  return first === "" ? `trial ${trial}` : `${first}, trial ${trial}`;
}
