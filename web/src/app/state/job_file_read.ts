/// A job file as a draft. The server has checked it, or will; what is not understood here is left at its default. A mesh
/// that names a path is looked for by its last part, and a file of several objects stands for all of them.

import type { Json, JsonObject, Mesh, Unit } from "../../api/types";
import type { KeepOut, Sides, Stands, TrayChoice } from "./draft";
import { type AxisName, anyWay, type Draft, type DraftPart, emptyDraft, freeKey, type Goal, newPart } from "./draft";

/// The name of a file without its folders.
export function baseName(path: string): string {
  return path.split(/[/\\]/).pop() ?? path;
}

export function fromJobFile(file: JsonObject, meshes: readonly Mesh[]): Draft {
  const options = { ...objectOf(file.options) };
  const take = (name: string): Json | undefined => {
    const value = options[name];
    delete options[name];
    return value ?? undefined;
  };
  const container = objectOf(file.container);
  const printer = textOf(take("printer"));
  const size = sidesOf(container.size ?? take("tray"));
  const openHeight = (file.open_height ?? take("open-height")) === true;
  const trays = file.trays ?? take("trays");
  const gap = numberOf(file.gap ?? take("gap"));
  const wallGap = numberOf(file.wall_gap ?? take("wall-gap"));
  const unit = unitOf(file.unit ?? take("unit"));
  const goal = goalOf(take, options["height-at"]);
  if (goal === "lowest") delete options["height-at"];
  const timeLimit = numberOf(take("time-limit"));
  const material = textOf(take("material"));
  return {
    parts: readParts(file.parts, meshes),
    unit: unit ?? "mm",
    tray: trayOf(container, printer, size),
    openHeight,
    trays: trays === "all" ? "all" : Math.max(1, Math.round(numberOf(trays) ?? 1)),
    keepOut: listOf(file.keep_out).flatMap(keepOutOf),
    gap,
    wallGap,
    goal,
    timeLimit,
    material: material ?? "",
    physical: container.physical === true,
    options,
    fixed: listOf(file.fixed).length > 0 ? (file.fixed ?? null) : null,
  };
}

function goalOf(take: (name: string) => Json | undefined, heightAt: Json | undefined): Goal {
  if (take("minimise") === "box") return "box";
  return heightAt === "top" ? "lowest" : "fill";
}

function trayOf(container: JsonObject, printer: string | null, size: Sides | null): TrayChoice {
  const mesh = textOf(container.mesh);
  if (mesh !== null) {
    const is = container.is;
    return {
      kind: "mesh",
      file: baseName(mesh),
      is: is === "solid" || is === "vessel" ? is : null,
      unit: unitOf(container.unit),
      transform: container.transform ?? null,
    };
  }
  if (size) return { kind: "box", size };
  return printer === null ? emptyDraft.tray : { kind: "printer", name: printer };
}

function keepOutOf(value: Json): KeepOut[] {
  const entry = objectOf(value);
  const mesh = textOf(entry.mesh);
  if (mesh !== null) {
    return [{ mesh: baseName(mesh), transform: entry.transform ?? null, unit: unitOf(entry.unit) }];
  }
  const [low, high] = listOf(entry.box).map(sidesOf);
  return low && high ? [{ box: [low, high] }] : [];
}

function readParts(value: Json | undefined, meshes: readonly Mesh[]): DraftPart[] {
  const parts: DraftPart[] = [];
  const taken = new Set<string>();
  for (const entry of listOf(value).map(objectOf)) {
    const path = textOf(entry.mesh);
    if (path === null) continue;
    const file = baseName(path);
    for (const object of objectsOf(file, textOf(entry.object), meshes)) {
      const key = freeKey(file, object, taken);
      taken.add(key);
      parts.push(readPart(entry, newPart(file, object, key)));
    }
  }
  return parts;
}

/// Those that the job names: one, or all that the file holds.
export function objectsOf(file: string, object: string | null, meshes: readonly Mesh[]): (string | null)[] {
  if (object !== null) return [object];
  const inFile = meshes.filter((mesh) => mesh.file === file);
  return inFile.length > 0 ? inFile.map((mesh) => mesh.object) : [null];
}

function readPart(entry: JsonObject, part: DraftPart): DraftPart {
  return {
    ...part,
    name: textOf(entry.name),
    count: Math.max(1, Math.round(numberOf(entry.count) ?? 1)),
    scale: numberOf(entry.scale) ?? 1,
    unit: unitOf(entry.unit),
    stands: standsOf(entry.orientations),
    gap: numberOf(entry.gap),
    priority: numberOf(entry.priority) ?? 0,
    due: textOf(entry.due),
    order: textOf(entry.order),
    value: numberOf(entry.value),
  };
}

export function standsOf(value: Json | undefined): Stands {
  if (value === "upright" || value === "fixed") return { kind: value };
  const entry = objectOf(value);
  if (entry.matrices) return { kind: "matrices", matrices: entry.matrices };
  const axes = listOf(entry.axes).filter(isAxis);
  return axes.length > 0 ? { kind: "axes", axes, yaw: numberOf(entry.yaw) } : anyWay;
}

export function isAxis(value: unknown): value is AxisName {
  return typeof value === "string" && /^[+-][xyz]$/.test(value);
}

export function unitOf(value: Json | undefined): Unit | null {
  return value === "mm" || value === "inch" || value === "m" ? value : null;
}

function objectOf(value: Json | undefined): JsonObject {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? (value as JsonObject) : {};
}

function listOf(value: Json | undefined): readonly Json[] {
  return Array.isArray(value) ? value : [];
}

const textOf = (value: Json | undefined): string | null => (typeof value === "string" && value !== "" ? value : null);

const numberOf = (value: Json | undefined): number | null =>
  typeof value === "number" && Number.isFinite(value) ? value : null;

/// Three lengths, or two: the third is 0 then.
function sidesOf(value: Json | undefined): Sides | null {
  const [x, y, z = 0] = listOf(value).map(numberOf);
  return typeof x === "number" && typeof y === "number" && z !== null ? [x, y, z] : null;
}
