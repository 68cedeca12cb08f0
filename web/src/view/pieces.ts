/// All copies: what stands where, how it looks, and the passes that draw it. Meshes are shapes (shapes.ts); what their
/// copies are lies in two textures (see shaders.ts).

import type { DataTexture } from "three";
import { type Box, determinant, emptyBox, grow } from "./affine";
import type { Surface } from "./ambient";
import { Copies } from "./copies";
import {
  asMark,
  buildLists,
  crossing,
  type Frustum,
  faint as faintKind,
  ghost,
  isWhollySeen,
  mayBeSeen,
  outlined,
  solid,
} from "./lists";
import { accentOutline, Looks, none } from "./looks";
import { disposeMaterials, type Materials, makeMaterials, type OutlineUniforms } from "./materials";
import { fadeTime, reducedMotion } from "./motion";
import { PassSet } from "./pass_set";
import { copyTexture, listTexture } from "./passes";
import { boxSide, crossed, cutAway, facesCut } from "./section";
import { pointsOn, Shapes } from "./shapes";
import { type SharedUniforms, sharedUniforms } from "./uniforms";
import type { CopyKey, MeshData, Section, Size, ViewCopy, ViewPart } from "./view";

/// A faint copy covers so much of what is behind it.
const faintShare = 0.16;
/// A mesh that lacks more than this of its surface has no inside to cut through: its walls are shown instead.
const mostOpen = 0.02;
/// One that lacks less than this is closed: its inner sides are never seen.
const leastOpen = 1e-4;
/// A copy that moved casts no shadow until it has stood so long: shadows are drawn anew only once it rests.
const restTime = 350;
/// ms after a copy landed that the next one is waited for.
const landingTime = 250;
export class Pieces {
  readonly copies = new Copies();
  readonly looks = new Looks();
  readonly shared: SharedUniforms = sharedUniforms();
  readonly passes: PassSet;
  /// Their shadows are out of date: all of them, or only these have come.
  shadowsDirty = true;
  shadowsAdded: number[] = [];

  private parts = new Map<number, ViewPart>();
  private readonly shapes = new Shapes((shape) => this.passes.remove(shape));
  private section: Section | null = null;
  private readonly materials: Materials;
  private listsDirty = true;
  private coloursDirty = true;
  private changed = new Set<number>();
  private landedAt = -Infinity;
  private fading = new Set<number>();
  private resting = new Set<number>();
  private shadowList = listTexture(1);
  private viewList = listTexture(1);
  private lastFrustum = "";
  private lastFacesCut = false;
  private extent: Box | null = null;
  private outlinedCount = 0;
  private drawnTriangles = 0;

  constructor(outline: OutlineUniforms) {
    this.materials = makeMaterials(this.shared, outline);
    this.passes = new PassSet(this.materials);
    this.shared.list.value = this.viewList;
    this.shared.copyData.value = copyTexture(64);
  }

  setParts(parts: readonly ViewPart[]): void {
    this.parts = new Map(parts.map((part) => [part.index, part]));
    this.shapes.clear();
    this.passes.clear();
    this.copies.clearParts();
    for (const { index, mesh } of parts) this.setMesh(index, mesh);
    this.afterClear();
  }

  /// `keep`: what was drawn before is still drawn while the picture moves.
  refine(meshes: ReadonlyMap<number, MeshData>, keep = false): void {
    for (const [index, mesh] of meshes) if (this.parts.has(index)) this.setMesh(index, mesh, keep);
    this.extent = null;
    this.listsDirty = true;
    this.shadowsDirty = true;
  }

  clear(): void {
    this.copies.clear();
    this.afterClear();
  }

  place(placed: readonly ViewCopy[], landing: boolean, now: number): void {
    const fades = landing && !reducedMotion();
    let latest: number | null = null;
    for (const copy of placed) {
      const done = this.copies.place(copy, now, fades);
      if (!done) continue;
      this.changed.add(done.slot);
      const shape = this.shapes.of(copy.part);
      if (shape && determinant(this.copies.rows, 12 * done.slot) < 0) shape.mirrored = true;
      if (fades) this.fading.add(done.slot);
      if (done.moved) {
        // The copy's old shadow goes when it begins to move, the new one comes when it rests.
        if (!this.resting.has(done.slot)) this.shadowsDirty = true;
        this.resting.add(done.slot);
      } else this.shadowsAdded.push(done.slot);
      latest = this.copies.keyNumberOf(done.slot);
    }
    if (landing) {
      this.looks.latest = latest;
      this.landedAt = now;
    }
    if (this.looks.colouring !== "part") this.coloursDirty = true;
    this.extent = null;
    this.listsDirty = true;
  }

  remove(keys: readonly CopyKey[]): void {
    for (const key of keys) {
      const slot = this.copies.slotOf(key);
      if (slot === undefined) continue;
      this.copies.remove(key);
      this.fading.delete(slot);
      this.resting.delete(slot);
      this.changed.delete(slot);
    }
    if (this.looks.colouring !== "part") this.coloursDirty = true;
    this.extent = null;
    this.listsDirty = true;
    this.shadowsDirty = true;
  }

  setSection(section: Section | null): void {
    this.section = section;
    this.listsDirty = true;
    this.shadowsDirty = true;
  }

  /// After anything in `looks` changed; `shadows`: also whether copies are drawn.
  looksChanged(shadows: boolean): void {
    this.coloursDirty = true;
    this.listsDirty = true;
    if (shadows) this.shadowsDirty = true;
  }

  meshOf(slot: number): MeshData | undefined {
    return this.shapes.of(this.copies.part[slot] as number)?.mesh;
  }

  nameOf(part: number): string {
    return this.parts.get(part)?.name ?? "";
  }

  /// What can be picked: all that is drawn solid.
  *pickable(): Iterable<number> {
    for (const slot of this.copies.all()) {
      if (!this.looks.isHidden(this.copies, slot) && !this.looks.isFaint(this.copies, slot)) yield slot;
    }
  }

  /// Round all copies, drawn or not; empty without any.
  bounds(): Readonly<Box> {
    if (!this.extent) {
      this.extent = emptyBox();
      for (const slot of this.copies.all()) grow(this.extent, this.copies.boxOf(slot));
    }
    return this.extent;
  }

  /// Colours are measured anew if needed, so that a legend is right at once.
  measure(): void {
    this.looks.measure(this.copies);
  }

  get hasOutlines(): boolean {
    return this.outlinedCount > 0;
  }

  get triangles(): number {
    return this.drawnTriangles;
  }

  /// Brings everything up to the moment, before a frame. Says whether another one is needed because something fades.
  update(now: number, frustum: Frustum, eye: Size): boolean {
    this.updateCopies(now);
    const facing = this.section !== null && facesCut(this.section, eye);
    const seen = this.frustumKey(frustum);
    if (this.listsDirty || seen !== this.lastFrustum || facing !== this.lastFacesCut) {
      this.lastFrustum = seen;
      this.lastFacesCut = facing;
      this.listsDirty = false;
      this.updateLists(frustum, facing);
    }
    return this.fading.size > 0;
  }

  /// The picture moves: the lighter meshes are drawn where there are any.
  setMoving(moving: boolean): void {
    if (moving === this.shapes.light) return;
    this.shapes.light = moving;
    this.listsDirty = true;
  }

  /// Whether there are meshes that are still drawn facet by facet and need not be.
  get isRough(): boolean {
    return this.shapes.isRough;
  }

  /// Works out normals for about so many ms.
  smoothSome(ms: number): void {
    if (this.shapes.smoothSome(ms)) this.listsDirty = true;
  }

  /// Copies that came to rest since they were last asked for; their shadows are due.
  rested(now: number): boolean {
    let any = false;
    for (const slot of this.resting) {
      if (now - (this.copies.movedAt[slot] as number) < restTime) continue;
      this.resting.delete(slot);
      any = true;
    }
    if (any) this.shadowsDirty = true;
    return any;
  }

  /// Copies land, or did a moment ago.
  isLanding(now: number): boolean {
    return now - this.landedAt < landingTime;
  }

  get anyResting(): boolean {
    return this.resting.size > 0;
  }

  /// Makes `shadowScene` ready: with all copies that cast a shadow, or only those that have come (`added`).
  prepareShadows(added: boolean): void {
    const only = added ? new Set(this.shadowsAdded) : null;
    const lists = buildLists(this.copies, this.shapes.all(), (slot) =>
      (only && !only.has(slot)) || !this.castsShadow(slot) ? 0 : solid,
    );
    this.shadowList = this.fill(this.shadowList, lists.list);
    for (const { shape, solids, solidCount } of lists.ranges) {
      this.passes.setShadow(shape, this.shapes.drawn(shape).geometry, solids, solidCount);
    }
    this.shadowsDirty = false;
    this.shadowsAdded = [];
  }

  /// The shadow pass reads its own list. Called round it.
  useShadowList(use: boolean): void {
    this.shared.list.value = use ? this.shadowList : this.viewList;
  }

  /// For the light between the copies, in cells of so many mm.
  *surfaces(cell: number): Iterable<Surface> {
    const r = this.copies.rows;
    for (const shape of this.shapes.all()) {
      for (const part of shape.parts) {
        for (const slot of this.copies.ofPart(part)) {
          if (!this.castsShadow(slot)) continue;
          const at = 12 * slot;
          // The transform's scale, from its first column.
          const scale = (r[at] as number) ** 2 + (r[at + 4] as number) ** 2 + (r[at + 8] as number) ** 2;
          const points = pointsOn(shape, scale, cell);
          const areaEach = (shape.facts.area * scale) / Math.max(1, points.length / 3);
          yield { points, rows: r, at, areaEach };
        }
      }
    }
  }

  /// Lets go of all memory on the graphics card; what is drawn again takes it again.
  release(): void {
    this.shapes.release();
    disposeMaterials(this.materials);
    this.passes.release();
    this.viewList.dispose();
    this.shadowList.dispose();
    this.shared.copyData.value?.dispose();
    this.shared.ambient.value.dispose();
  }

  dispose(): void {
    this.release();
    this.parts.clear();
    this.shapes.clear();
  }

  private afterClear(): void {
    this.fading.clear();
    this.resting.clear();
    this.changed.clear();
    this.shadowsAdded = [];
    this.looks.latest = null;
    this.extent = null;
    this.listsDirty = true;
    this.shadowsDirty = true;
  }

  private setMesh(part: number, mesh: MeshData, keep = false): void {
    this.copies.setPart(part, this.shapes.set(part, mesh, keep).facts.box);
  }

  private castsShadow(slot: number): boolean {
    if (this.resting.has(slot)) return false;
    if (this.looks.isHidden(this.copies, slot) || this.looks.isFaint(this.copies, slot)) return false;
    return this.section === null || boxSide(this.section, this.copies.boxes, 6 * slot) !== cutAway;
  }

  /// Transforms and colours into the copies' texture.
  private updateCopies(now: number): void {
    let texture = this.shared.copyData.value as DataTexture;
    const { copies, looks } = this;
    let all = this.coloursDirty;
    if (16 * copies.end > (texture.image.data as Float32Array).length) {
      texture.dispose();
      texture = copyTexture(2 * copies.end);
      this.shared.copyData.value = texture;
      all = true;
    }
    for (const slot of this.fading) {
      this.changed.add(slot);
      if (now - (copies.landedAt[slot] as number) < fadeTime) continue;
      this.fading.delete(slot);
      this.listsDirty = true;
    }
    if (!all && this.changed.size === 0) return;
    if (all) looks.measure(copies);
    const data = texture.image.data as Float32Array;
    for (const slot of all ? copies.all() : this.changed) {
      data.set(copies.rows.subarray(12 * slot, 12 * slot + 12), 16 * slot);
      const [r, g, b] = looks.colourOf(copies, slot);
      const faded = Math.min(1, Math.max(0.02, (now - (copies.landedAt[slot] as number)) / fadeTime));
      data[16 * slot + 12] = r;
      data[16 * slot + 13] = g;
      data[16 * slot + 14] = b;
      data[16 * slot + 15] = looks.isFaint(copies, slot) ? faintShare * faded : faded;
    }
    texture.needsUpdate = true;
    this.changed.clear();
    this.coloursDirty = false;
  }

  private updateLists(frustum: Frustum, facesTheCut: boolean): void {
    const { copies, looks, section } = this;
    const lists = buildLists(copies, this.shapes.all(), (slot) => {
      if (looks.isHidden(copies, slot)) return 0;
      const side = section ? boxSide(section, copies.boxes, 6 * slot) : 0;
      if (section && side === cutAway) return 0;
      if (!mayBeSeen(frustum, copies.boxes, 6 * slot)) return 0;
      const faint = looks.isFaint(copies, slot);
      let kind = faint ? faintKind : this.fading.has(slot) ? ghost : solid;
      const shape = this.shapes.of(copies.part[slot] as number);
      if (side === crossed && facesTheCut && shape && shape.facts.openness < mostOpen) kind |= crossing;
      const outline = faint ? none : looks.outlineOf(copies, slot);
      if (outline !== none) kind |= outline === accentOutline ? outlined : outlined | asMark;
      return kind;
    });
    this.viewList = this.fill(this.viewList, lists.list);
    this.shared.list.value = this.viewList;
    this.outlinedCount = 0;
    this.drawnTriangles = 0;
    this.passes.setFaint(lists.ranges.some((r) => r.faintCount > 0));
    for (const ranges of lists.ranges) {
      const { shape } = ranges;
      const { geometry, triangles } = this.shapes.drawn(shape);
      this.passes.set(ranges, geometry, shape.mirrored || shape.facts.openness > leastOpen);
      this.drawnTriangles += triangles * (ranges.solidCount + ranges.ghostCount + ranges.faintCount);
      this.outlinedCount += ranges.outlineCount;
    }
    this.passes.setSection(section, this.bounds());
  }

  private fill(texture: DataTexture, list: Uint32Array): DataTexture {
    let target = texture;
    if (list.length > (target.image.data as Uint32Array).length) {
      target.dispose();
      target = listTexture(2 * list.length);
    }
    (target.image.data as Uint32Array).set(list);
    target.needsUpdate = true;
    return target;
  }

  /// Two frustums are alike for the lists as long as all that stands is wholly in both.
  private frustumKey(frustum: Frustum): string {
    return isWhollySeen(frustum, this.bounds(), 0) ? "all" : frustum.map((plane) => plane.join()).join();
  }
}
