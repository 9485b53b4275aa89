// Moving between dots with the arrow keys.

export interface Dot {
  x: number;
  y: number;
}

/** The number of the nearest dot in the given direction (within 45 degrees), or `from`. */
export function nearestTowards(dots: readonly Dot[], from: number, dx: number, dy: number): number {
  const at = dots[from];
  if (!at) return from;
  let best = from;
  let least = Number.POSITIVE_INFINITY;
  dots.forEach((dot, i) => {
    const along = (dot.x - at.x) * dx + (dot.y - at.y) * dy;
    const beside = Math.abs((dot.x - at.x) * dy) + Math.abs((dot.y - at.y) * dx);
    if (along < 0.2 || beside > along + 0.3 || along + beside >= least) return;
    least = along + beside;
    best = i;
  });
  return best;
}
