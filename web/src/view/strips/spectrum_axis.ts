// The frequencies of a spectrum's values: its module states how they are spaced, the channel how
// many frames there are per second.

import type { ModuleData } from "../../parts/data";
import type { State } from "../data";
import type { Axis } from "../systems/plotter";

/** Null for other modules, several spectra, and bands that are not evenly spaced. */
export function spectrumAxis(module: ModuleData, state: State): Axis | null {
  if (module.type !== "spectrum" || module.shape.filter((size) => size > 1).length !== 1) return null;
  if (module.parameters["bands"] !== "0" && module.parameters["band_spacing"] !== '"linear"') return null;
  const rate = state.rates[channelOf(module, state) ?? ""] ?? 0;
  if (rate <= 0) return null;
  const number = (name: string, otherwise: number) => {
    const value = Number(module.parameters[name]);
    return Number.isFinite(value) ? value : otherwise;
  };
  return { low: number("low", 0), high: number("high", rate / 2), unit: "Hz" };
}

/** The channel from which a module receives its values, through others. */
function channelOf(module: ModuleData, state: State): string | null {
  const modules = state.graph?.modules ?? [];
  const seen = new Set<string>();
  let at: ModuleData | undefined = module;
  while (at !== undefined && !seen.has(at.name)) {
    if (at.type === "channel") return at.channel ?? null;
    seen.add(at.name);
    const input: string | undefined = at.inputs[0]?.module;
    at = modules.find(({ name }) => name === input);
  }
  return null;
}
