/// What of a build is looked at, and how. It belongs to the page alone; nothing of it changes the packing.

import type { Colouring, CopyKey, Section } from "../../view/view";
import { copyId } from "./live_run";
import { Store } from "./store";

export interface BuildView {
  /// From 1 on; 0: all side by side.
  readonly tray: number;
  /// While it packs: the tray that is being filled is shown.
  readonly follow: boolean;
  readonly colouring: Colouring;
  readonly section: Section | null;
  readonly selected: readonly CopyKey[];
  readonly hiddenParts: ReadonlySet<number>;
  readonly hiddenCopies: ReadonlySet<string>;
  /// Only these are shown; null: all.
  readonly isolated: ReadonlySet<string> | null;
  readonly find: string | null;
}

const start: BuildView = {
  tray: 1,
  follow: true,
  colouring: "part",
  section: null,
  selected: [],
  hiddenParts: new Set(),
  hiddenCopies: new Set(),
  isolated: null,
  find: null,
};

export const newBuildView = () => new Store<BuildView>(start);

export function isHidden(view: BuildView, copy: CopyKey): boolean {
  const id = copyId(copy);
  if (view.isolated && !view.isolated.has(id)) return true;
  return view.hiddenParts.has(copy.part) || view.hiddenCopies.has(id);
}

export function anyHidden(view: BuildView): boolean {
  return view.isolated !== null || view.hiddenParts.size > 0 || view.hiddenCopies.size > 0;
}

export const showAll = { hiddenParts: new Set<number>(), hiddenCopies: new Set<string>(), isolated: null };

export function toggledPart(view: BuildView, part: number): Partial<BuildView> {
  const hiddenParts = new Set(view.hiddenParts);
  if (!hiddenParts.delete(part)) hiddenParts.add(part);
  return { hiddenParts };
}

export function hideSelected(view: BuildView): Partial<BuildView> {
  if (view.selected.length === 0) return {};
  return { hiddenCopies: new Set([...view.hiddenCopies, ...view.selected.map(copyId)]), selected: [] };
}

export function isolateSelected(view: BuildView): Partial<BuildView> {
  if (view.isolated) return { isolated: null };
  return view.selected.length > 0 ? { isolated: new Set(view.selected.map(copyId)) } : {};
}

export function toggledSelection(selected: readonly CopyKey[], copy: CopyKey): CopyKey[] {
  const rest = selected.filter((other) => copyId(other) !== copyId(copy));
  return rest.length < selected.length ? rest : [...selected, copy];
}

export const colourings: readonly { readonly value: Colouring; readonly text: string }[] = [
  { value: "part", text: "Part" },
  { value: "order", text: "Order" },
  { value: "height", text: "Height" },
  { value: "way", text: "Way out" },
];

export function nextColouring(colouring: Colouring): Colouring {
  const place = colourings.findIndex((entry) => entry.value === colouring);
  return colourings[(place + 1) % colourings.length]?.value ?? "part";
}
