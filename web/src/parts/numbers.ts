// Numbers as a person reads them: every number that a page shows is formatted here.
//
//   readable(0.12345)              0.123: numbers that stand still
//   digits(0.12345)                0.12: numbers that change while they are read
//   withUnit(digits(1.5), "N")     1.50 N
//   percent(0.999)                 > 99 %

type Value = number | null | undefined;

const kNothing = "–"; // stands for a missing value

function isThere(value: Value): value is number {
  return value !== null && value !== undefined && Number.isFinite(value);
}

function minus(text: string): string {
  return text.replace("-", "−");
}

/** Three figures that count; "–" for what is not there. */
export function readable(value: Value): string {
  if (!isThere(value)) return kNothing;
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return minus(value.toExponential(2));
  return significant(value, size >= 1000 ? 6 : 3);
}

/** `figures` significant figures, without zeros at the end. */
export function significant(value: number, figures: number): string {
  return minus(String(Number(value.toPrecision(figures))));
}

/** Always this number of decimals; "–" for a missing value. */
export function fixed(value: Value, decimals: number): string {
  return isThere(value) ? minus(value.toFixed(decimals)) : kNothing;
}

/** 0.01, 1.23, 12.3, 123: numbers of one size have equally many decimals, so that changing ones do not jump. */
export function digits(value: Value): string {
  const size = Math.abs(value ?? 0);
  return fixed(value, size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2);
}

/** As digits(), with four decimals below 0.1: weights and normalized values are often small. */
export function fineDigits(value: number): string {
  return value !== 0 && Math.abs(value) < 0.1 ? fixed(value, 4) : digits(value);
}

/** Two decimals, so that numbers in a column can be compared; from 100 on as readable(). */
export function hundredths(value: Value): string {
  return Math.abs(value ?? 0) < 100 ? fixed(value, 2) : readable(value);
}

/** A formatted number with its unit, where it has one. */
export function withUnit(words: string, unit: string): string {
  return unit === "" ? words : `${words} ${unit}`;
}

export function seconds(value: number): string {
  return withUnit(fixed(value, 1), "s");
}

export function percent(share: Value): string {
  if (!isThere(share)) return kNothing;
  const rounded = Math.round(share * 100);
  // A share close to 0 or 1 must not be rounded to 0 % or 100 %.
  if (rounded === 100 && share < 1) return "> 99 %";
  if (rounded === 0 && share > 0) return "< 1 %";
  return `${rounded} %`;
}

export function countOf(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

/** Minimum and maximum of the numbers present; null without any. */
export function rangeOf(values: readonly (number | null)[]): [number, number] | null {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const value of values) {
    if (value === null || !Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return low <= high ? [low, high] : null;
}

/** The median of sorted numbers; null without any. */
export function median(sorted: readonly number[]): number | null {
  if (sorted.length === 0) return null;
  const half = (sorted.length - 1) / 2;
  return ((sorted[Math.floor(half)] ?? 0) + (sorted[Math.ceil(half)] ?? 0)) / 2;
}

/** With spaces and a capital letter. */
export function capital(name: string): string {
  const words = name.replaceAll("_", " ");
  return words.slice(0, 1).toUpperCase() + words.slice(1);
}
