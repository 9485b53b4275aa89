// A short name of an exploration.

/**
 * "boule, trial 2": the label of the system, otherwise the object, otherwise the first label.
 */
export function describe(labels: Record<string, string>, label: string | null = null): string {
  const { object, trial } = labels;
  const first = labels[label ?? ""] ?? object ?? Object.values(labels)[0] ?? "";
  if (trial === undefined) return first;
  return first === "" ? `trial ${trial}` : `${first}, trial ${trial}`;
}
