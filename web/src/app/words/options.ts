/// Names and help of options, from the program's table, without the command line's dashes.

import type { Option } from "../../api/types";
import { plain, sentence } from "./sentence";

/// "max-layer-fill" as "Max layer fill".
export function label(name: string): string {
  const words = name.replaceAll("-", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export function helpOf(option: Option): string {
  return option.help ? `${sentence(option.line)} ${plain(option.help)}` : sentence(option.line);
}

/// The default where nothing is set, for a placeholder.
export function defaultText(option: Option): string {
  return plain(option.default);
}

const groups: Readonly<Record<string, string>> = {
  parts: "Parts",
  tray: "Tray",
  gap: "Gap",
  packing: "Packing",
  result: "Result",
};

export function groupTitle(group: string): string {
  return groups[group.toLowerCase()] ?? label(group);
}
