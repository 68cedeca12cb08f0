/// What improving did, in words.

import { count, percent, thin } from "./numbers";

/// Whether less of it is better.
export const lessIsBetter = (what: string): boolean => what === "height" || what === "box" || what === "trays";

const cubic = (value: number): string => `${(value / 1000).toFixed(0)}${thin}cm³`;

/// The value itself: "362.4 mm".
export function valueWords(what: string, value: number): string {
  switch (what) {
    case "height":
      return `${value.toFixed(1)}${thin}mm`;
    case "density":
      return percent(value, 2);
    case "copies":
      return count(value);
    case "box":
      return cubic(value);
    case "trays":
      return value.toFixed(2);
    default:
      return Number(value.toPrecision(6)).toString();
  }
}

/// What it is a value of: "height".
export function valueName(what: string): string {
  const names: Readonly<Record<string, string>> = {
    height: "height",
    density: "filled",
    copies: "copies placed",
    box: "volume of the box",
    trays: "trays",
    value: "value placed",
  };
  return names[what] ?? what;
}

/// "12.3 mm lower", or null where nothing was gained.
export function gainWords(what: string, before: number, now: number): string | null {
  const gain = lessIsBetter(what) ? before - now : now - before;
  if (!(gain > 0)) return null;
  switch (what) {
    case "height":
      return gain < 0.05 ? null : `${gain.toFixed(1)}${thin}mm lower`;
    case "density":
      return `${percent(gain, 2)} more filled`;
    case "copies":
      return gain === 1 ? "1 copy more" : `${count(gain)} copies more`;
    case "box":
      return `${cubic(gain)} smaller`;
    case "trays":
      return `${gain.toFixed(2)} trays less`;
    default:
      return `${valueWords(what, gain)} more`;
  }
}

/// A sentence: "Made better: 12.3 mm lower, 362.7 mm instead of 375.0 mm."
export function improvedWords(what: string, before: number, now: number): string {
  const gain = gainWords(what, before, now);
  if (!gain) return "Nothing better was found.";
  return `Made better: ${gain}, ${valueWords(what, now)} instead of ${valueWords(what, before)}.`;
}
