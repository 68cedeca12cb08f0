/// Options of the program's table as fields: what kind of field, and its value in a job file.

import type { Json, Option } from "../../api/types";
import { parseNumber } from "../words/numbers";

/// Options that the page has a field of its own for.
const ownFields = new Set([
  "tray",
  "printer",
  "trays",
  "gap",
  "wall-gap",
  "open-height",
  "minimise",
  "time-limit",
  "material",
  "unit",
]);

/// Options that say how a command line runs, not what is packed.
const ofTheCommand = new Set(["dry-run", "json", "progress", "details", "require-all", "skip-unusable", "job-name"]);

export function advancedOptions(options: readonly Option[]): Option[] {
  return options.filter((option) => option.here && !ownFields.has(option.name) && !ofTheCommand.has(option.name));
}

export type FieldKind = "switch" | "choice" | "number" | "text";

export function fieldKind(option: Option): FieldKind {
  switch (option.type) {
    case "flag":
      return "switch";
    case "word":
    case "rotations":
      return "choice";
    case "integer":
    case "natural":
    case "number":
      return "number";
    default:
      return "text";
  }
}

/// A flag that is on where nothing is said.
export function onByDefault(option: Option): boolean {
  return option.type === "flag" && option.default.startsWith("on");
}

/// What a choice offers: the words, and the one that stands for none.
export function choices(option: Option): string[] {
  const none = option.none_word && !option.words.includes(option.none_word) ? [option.none_word] : [];
  return [...none, ...option.words];
}

/// The choice that is taken where nothing is said; null where that is none of them.
export function defaultChoice(option: Option): string | null {
  const first = option.default.split(/[:\s]/)[0] ?? "";
  return choices(option).find((choice) => choice === first) ?? null;
}

export type Read = { readonly value: Json | undefined } | { readonly problem: string };

/// What somebody typed into the field of an option. Nothing typed: the default.
export function readOption(option: Option, text: string): Read {
  const typed = text.trim();
  if (typed === "") return { value: undefined };
  if (typed === option.none_word || typed === option.zero_word) return { value: typed };
  if (fieldKind(option) !== "number" && option.type !== "bytes") return { value: typed };
  const value = option.type === "bytes" ? readBytes(typed) : parseNumber(typed);
  if (value === null) return { problem: `Takes ${option.values}.` };
  const whole = option.type === "integer" || option.type === "natural" || option.type === "bytes";
  const low = option.least !== undefined && (option.above ? value <= option.least : value < option.least);
  const high = option.most !== undefined && value > option.most;
  if (low || high || (whole && !Number.isInteger(value))) return { problem: `Takes ${option.values}.` };
  return { value };
}

/// "4G", "500 M", "2Gi": as on the command line.
function readBytes(text: string): number | null {
  const match = /^(.*?)([kmgt]?)(i?)b?$/i.exec(text);
  const value = parseNumber(match?.[1] ?? "");
  if (value === null || !match) return null;
  const power = "kmgt".indexOf((match[2] ?? "").toLowerCase()) + 1;
  return Math.round(value * (match[3] ? 1024 : 1000) ** (match[2] ? power : 0));
}

export function optionText(value: Json | undefined): string {
  return value === undefined || value === null ? "" : String(value);
}
