// Colours cells by values, and touches only those whose colour changes.
//
//   const paint = painter(cells, sequenceColour);
//   paint(values, low, high);

// Colours are taken in so many steps: what changes less is not drawn again.
const kSteps = 128;

export type Paint = (values: readonly (number | null)[], low: number, high: number) => void;

export function painter(cells: readonly SVGPathElement[], colour: (share: number) => string): Paint {
  const table = Array.from({ length: kSteps + 1 }, (_, step) => colour(step / kSteps));
  const steps = new Int16Array(cells.length).fill(-2);
  return (values, low, high) => {
    const scale = high > low ? kSteps / (high - low) : 0;
    cells.forEach((cell, i) => {
      const value = values[i];
      const step = value === null || value === undefined ? -1 : stepOf((value - low) * scale);
      if (steps[i] === step) return;
      steps[i] = step;
      cell.setAttribute("fill", table[step] ?? "none");
    });
  };
}

function stepOf(place: number): number {
  return Number.isFinite(place) ? Math.round(Math.min(kSteps, Math.max(0, place))) : -1;
}
