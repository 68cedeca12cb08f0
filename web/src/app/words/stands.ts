/// How a part may stand, in words.

import type { IconName } from "../common/icons";
import type { AxisName, Stands } from "../state/draft";

export type StandsKind = Stands["kind"];

export const standsChoices: readonly { readonly value: StandsKind; readonly text: string; readonly icon: IconName }[] =
  [
    { value: "any", text: "Any way", icon: "any" },
    { value: "upright", text: "Upright", icon: "upright" },
    { value: "fixed", text: "As drawn", icon: "drawn" },
    { value: "axes", text: "Axes", icon: "axes" },
  ];

export function standsText(stands: Stands): string {
  if (stands.kind === "axes") {
    const up = [...new Set(stands.axes.map((axis) => axis.slice(1).toUpperCase()))];
    return up.length === 1 ? `About ${up[0]}` : "Axes";
  }
  if (stands.kind === "matrices") return "As listed";
  return standsChoices.find((choice) => choice.value === stands.kind)?.text ?? "";
}

export function standsIcon(stands: Stands): IconName {
  return standsChoices.find((choice) => choice.value === stands.kind)?.icon ?? "axes";
}

/// The same kind, or one with what that kind needs.
export function standsOfKind(kind: StandsKind, before: Stands): Stands {
  if (kind === before.kind) return before;
  if (kind === "axes") return { kind, axes: ["+z", "-z"], yaw: null };
  return kind === "matrices" ? before : { kind };
}

export const axisNames: readonly AxisName[] = ["+x", "-x", "+y", "-y", "+z", "-z"];

export const axisText = (axis: AxisName): string => axis.toUpperCase().replace("-", "−");

/// What a choice means, for the line below it.
export function standsHelp(stands: Stands, rotations: string): string {
  switch (stands.kind) {
    case "any":
      return rotations;
    case "upright":
      return "Turned about the vertical only; its top stays up.";
    case "fixed":
      return "As it lies in its file.";
    case "axes":
      return "One of these directions of the part points up.";
    default:
      return "Turns listed in the job file.";
  }
}

/// How many ways there are to stand, of a step of turns.
export function rotationsText(rotations: unknown): string {
  if (rotations === undefined || rotations === "90" || rotations === 90) return "24 positions tried";
  if (rotations === "none") return "As in the file: turns are off";
  if (rotations === "45" || rotations === 45) return "208 positions tried";
  return `Turned in steps: ${rotations}`;
}

export const priorities: readonly { readonly value: string; readonly text: string }[] = [
  { value: "1", text: "First" },
  { value: "0", text: "Normal" },
  { value: "-1", text: "If room" },
];

export function priorityText(priority: number): string {
  const known = priorities.find((choice) => Number(choice.value) === priority);
  return known?.text ?? String(priority);
}
