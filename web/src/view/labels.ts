// An exploration in a few words.

/**
 * "boule, trial 2": by what the system tells, else by the object, else by whatever comes first.
 */
export function describe(labels: Record<string, string>, told: string | null = null): string {
  const { object, trial } = labels;
  const first = labels[told ?? ""] ?? object ?? Object.values(labels)[0] ?? "";
  if (trial === undefined) return first;
  return first === "" ? `trial ${trial}` : `${first}, trial ${trial}`;
}
