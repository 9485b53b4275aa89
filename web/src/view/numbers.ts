// Numbers that change while they are read: always as many decimals, so that they do not jump.

/** 0.0123, 1.23, 12.3, 123. */
export function digits(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const decimals = size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2;
  return value.toFixed(decimals).replace(/^-/, "−");
}

export function withUnit(value: number, unit: string): string {
  return unit === "" ? digits(value) : `${digits(value)} ${unit}`;
}

export function seconds(value: number): string {
  return `${value.toFixed(1)} s`;
}
