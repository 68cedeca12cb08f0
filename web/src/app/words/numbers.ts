/// Numbers and sizes as the page says them. Between a number and its unit stands a thin space that does not break.

export const thin = "\u202f";

/// Thousands apart: 3 598.
export function count(value: number): string {
  return Math.round(value)
    .toString()
    .replace(/\B(?=(\d{3})+$)/g, thin);
}

/// At most `digits` behind the point, none that say nothing.
export function short(value: number, digits = 2): string {
  return Number(value.toFixed(digits)).toString();
}

export const mm = (value: number, digits = 1): string => `${value.toFixed(digits)}${thin}mm`;

export const percent = (share: number, digits = 1): string => `${(share * 100).toFixed(digits)}${thin}%`;

/// "1 copy", "12 copies".
export function counted(value: number, one: string, many = `${one}s`): string {
  return `${count(value)} ${value === 1 ? one : many}`;
}

export const copies = (value: number): string => counted(value, "copy", "copies");

/// 44th, 101st, 12th.
export function ordinal(value: number): string {
  const tens = value % 100;
  const ending = tens > 10 && tens < 14 ? "th" : (["th", "st", "nd", "rd"][value % 10] ?? "th");
  return `${count(value)}${ending}`;
}

export function bytes(value: number): string {
  const units = ["bytes", "kB", "MB", "GB", "TB"];
  let size = value;
  let unit = 0;
  while (size >= 999.5 && unit < units.length - 1) {
    size /= 1000;
    unit += 1;
  }
  const text = unit === 0 || size >= 10 ? size.toFixed(0) : size.toFixed(1);
  return `${text}${thin}${units[unit]}`;
}

/// A volume in mm³: as cm³, or litres.
export function volume(cubic: number): string {
  const centimetres = cubic / 1000;
  if (centimetres >= 1000) return `${short(centimetres / 1000, centimetres >= 10_000 ? 1 : 2)} litres`;
  if (centimetres >= 1) return `${centimetres.toFixed(1)}${thin}cm³`;
  return `${count(cubic)}${thin}mm³`;
}

export type LengthUnit = "mm" | "inch";

/// Three sides: whole millimetres where that says enough; `fine`: one digit more.
export function size(sides: readonly number[], fine = false, unit: LengthUnit = "mm"): string {
  const lengths = unit === "inch" ? sides.map((side) => side / 25.4) : sides;
  const small = Math.max(...lengths) < 19.5 || Math.min(...lengths) < 0.95;
  const digits = unit === "inch" ? 2 : fine || small ? 1 : 0;
  return `${lengths.map((side) => side.toFixed(digits)).join(" × ")}${thin}${unit === "inch" ? "in" : "mm"}`;
}

/// What somebody typed: "3,5" and "1 200" are numbers, too. Null where it is none.
export function parseNumber(text: string): number | null {
  const plain = text.replace(/[\s\u202f\u2009]/g, "").replace(",", ".");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}
