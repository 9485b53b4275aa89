// The value that stands for several elements and moments which share a pixel.

import type { NumberOrNull } from "../../parts/data";

/** The values at the moments that share a column of pixels; [] if unknown. */
export type Column = readonly (readonly NumberOrNull[])[];

/** The greatest magnitude of these elements; null if all of their values are missing. */
export function strongest(rows: Column, first: number, end: number): number | null {
  let most: number | null = null;
  for (const values of rows)
    for (let i = first; i < end; i += 1) {
      const value = values[i] ?? null;
      if (value !== null) most = Math.max(most ?? 0, Math.abs(value));
    }
  return most;
}
