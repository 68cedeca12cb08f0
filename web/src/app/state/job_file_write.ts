/// A draft as a job file (docs/format.md): only what differs from the defaults, so that the file reads well by hand.

import type { Json, JsonObject } from "../../api/types";
import { type Draft, type DraftPart, holdsAllInOne, type KeepOut, type Stands } from "./draft";

type Entries = { [key: string]: Json };

/// `there`: whether a file is on the server, which takes no job that names others; all are where nothing is said.
export function toJobFile(draft: Draft, there: (file: string) => boolean = () => true): JsonObject {
  const file: Entries = { format: "spectralpack/job", version: 1, unit: draft.unit };
  const container = containerOf(draft, there);
  if (container) file.container = container;
  if (draft.openHeight) file.open_height = true;
  if (draft.trays !== 1 && !holdsAllInOne(draft)) file.trays = draft.trays;
  const keepOut = draft.keepOut.filter((own) => "box" in own || there(own.mesh));
  if (keepOut.length > 0) file.keep_out = keepOut.map(keepOutOf);
  if (draft.gap !== null) file.gap = draft.gap;
  if (draft.wallGap !== null) file.wall_gap = draft.wallGap;
  if (draft.fixed !== null) file.fixed = draft.fixed;
  file.parts = draft.parts.filter((part) => there(part.file)).map(partOf);
  const options = optionsOf(draft);
  if (Object.keys(options).length > 0) file.options = options;
  return file;
}

function containerOf(draft: Draft, there: (file: string) => boolean): Json {
  const tray = draft.tray;
  if (tray.kind === "mesh") {
    if (tray.file === null || !there(tray.file)) return null;
    const container: Entries = { mesh: tray.file };
    if (tray.transform !== null) container.transform = tray.transform;
    if (tray.unit !== null) container.unit = tray.unit;
    if (tray.is !== null) container.is = tray.is;
    if (draft.physical) container.physical = true;
    return container;
  }
  if (tray.kind === "printer") return null;
  const container: Entries = { size: draft.openHeight && tray.size[2] === 0 ? tray.size.slice(0, 2) : tray.size };
  if (draft.physical) container.physical = true;
  return container;
}

function keepOutOf(keepOut: KeepOut): Json {
  if ("box" in keepOut) return { box: keepOut.box };
  const entry: Entries = { mesh: keepOut.mesh };
  if (keepOut.transform !== null) entry.transform = keepOut.transform;
  if (keepOut.unit !== null) entry.unit = keepOut.unit;
  return entry;
}

function partOf(part: DraftPart): Json {
  const entry: Entries = {};
  if (part.name !== null) entry.name = part.name;
  entry.mesh = part.file;
  if (part.object !== null) entry.object = part.object;
  entry.count = part.count;
  if (part.scale !== 1) entry.scale = part.scale;
  if (part.unit !== null) entry.unit = part.unit;
  if (part.stands.kind !== "any") entry.orientations = orientationsOf(part.stands);
  if (part.gap !== null) entry.gap = part.gap;
  if (part.priority !== 0) entry.priority = part.priority;
  if (part.due !== null) entry.due = part.due;
  if (part.order !== null) entry.order = part.order;
  if (part.value !== null) entry.value = part.value;
  return entry;
}

function orientationsOf(stands: Stands): Json {
  if (stands.kind === "axes")
    return stands.yaw === null ? { axes: stands.axes } : { axes: stands.axes, yaw: stands.yaw };
  if (stands.kind === "matrices") return { matrices: stands.matrices };
  return stands.kind;
}

function optionsOf(draft: Draft): Entries {
  const options: Entries = {};
  if (draft.tray.kind === "printer") options.printer = draft.tray.name;
  if (draft.goal === "lowest") options["height-at"] = "top";
  if (draft.goal === "box") options.minimise = "box";
  if (draft.timeLimit !== null) options["time-limit"] = draft.timeLimit;
  if (draft.material !== "") options.material = draft.material;
  for (const [name, value] of Object.entries(draft.options)) {
    // Improving until the limit says nothing without one.
    if (name === "improve" && value === "rest" && draft.timeLimit === null) continue;
    options[name] = value;
  }
  return options;
}
