/// All passes over the copies, in the order in which they are drawn (see materials.ts for what each does).

import { Group, type InstancedBufferGeometry, Mesh, PlaneGeometry, Scene } from "three";
import type { Box } from "./affine";
import type { Ranges } from "./lists";
import type { Materials } from "./materials";
import { Pass } from "./passes";
import { planeAt } from "./section";
import type { Shape } from "./shapes";
import type { Section } from "./view";

export class PassSet {
  /// For the picture: faint copies, cut faces, solid copies, those that fade in.
  readonly picture = new Group();
  /// For the picture of what the outlined copies cover.
  readonly outlines = new Scene();
  /// For the sun's depth map.
  readonly shadows = new Scene();

  private readonly all: Pass[] = [];
  private readonly faintDepth: Pass;
  private readonly faint: Pass;
  private readonly faintForget: Mesh;
  private readonly cutInner: Pass;
  private readonly cutOuter: Pass;
  private readonly cutPlane: Mesh;
  private readonly solid: Pass;
  private readonly solidBoth: Pass;
  private readonly ghostDepth: Pass;
  private readonly ghost: Pass;
  private readonly outlineInner: Pass;
  private readonly outlineOuter: Pass;
  private readonly outlineErase: Mesh;
  private readonly outline: Pass;
  private readonly shadow: Pass;
  private readonly quad = new PlaneGeometry(1, 1);

  constructor(materials: Materials) {
    const pass = (material: Materials[keyof Materials]): Pass => {
      const made = new Pass(material);
      this.all.push(made);
      return made;
    };
    const quad = (material: Materials[keyof Materials]): Mesh => {
      const mesh = new Mesh(this.quad, material);
      mesh.frustumCulled = mesh.matrixAutoUpdate = mesh.matrixWorldAutoUpdate = mesh.visible = false;
      return mesh;
    };
    this.faintDepth = pass(materials.ghostDepth);
    this.faint = pass(materials.ghost);
    this.faintForget = quad(materials.forgetDepth);
    this.cutInner = pass(materials.cutInner);
    this.cutOuter = pass(materials.cutOuter);
    this.cutPlane = quad(materials.cutPlane);
    this.solid = pass(materials.solid);
    this.solidBoth = pass(materials.solidBoth);
    this.ghostDepth = pass(materials.ghostDepth);
    this.ghost = pass(materials.ghost);
    this.outlineInner = pass(materials.outlineInner);
    this.outlineOuter = pass(materials.cutOuter);
    this.outlineErase = quad(materials.outlineErase);
    this.outline = pass(materials.outline);
    this.shadow = pass(materials.shadow);
    this.picture.add(this.faintDepth.group, this.faint.group, this.faintForget);
    this.picture.add(this.cutInner.group, this.cutOuter.group, this.cutPlane);
    this.picture.add(this.solid.group, this.solidBoth.group);
    this.picture.add(this.ghostDepth.group, this.ghost.group);
    this.outlines.add(this.outlineInner.group, this.outlineOuter.group, this.outlineErase, this.outline.group);
    this.shadows.add(this.shadow.group);
    // Nothing in them has a place of its own that three.js would have to work out.
    this.picture.matrixWorldAutoUpdate = false;
    this.outlines.matrixWorldAutoUpdate = this.shadows.matrixWorldAutoUpdate = false;
  }

  /// `bothSides`: the mesh's inner sides may be seen.
  set(r: Ranges<Shape>, geometry: InstancedBufferGeometry, bothSides: boolean): void {
    this.faintDepth.set(r.shape.number, geometry, r.faints, r.faintCount);
    this.faint.set(r.shape.number, geometry, r.faints, r.faintCount);
    this.cutInner.set(r.shape.number, geometry, r.solids, r.cuts);
    this.cutOuter.set(r.shape.number, geometry, r.solids, r.cuts);
    this.solid.set(r.shape.number, geometry, r.solids, bothSides ? 0 : r.solidCount);
    this.solidBoth.set(r.shape.number, geometry, r.solids, bothSides ? r.solidCount : 0);
    this.ghostDepth.set(r.shape.number, geometry, r.ghosts, r.ghostCount);
    this.ghost.set(r.shape.number, geometry, r.ghosts, r.ghostCount);
    this.outlineInner.set(r.shape.number, geometry, r.outlines, r.outlineCuts);
    this.outlineOuter.set(r.shape.number, geometry, r.outlines, r.outlineCuts);
    this.outline.set(r.shape.number, geometry, r.outlines, r.outlineCount);
  }

  /// Whether there are faint copies at all.
  setFaint(any: boolean): void {
    this.faintForget.visible = any;
  }

  setShadow(shape: Shape, geometry: InstancedBufferGeometry, base: number, count: number): void {
    this.shadow.set(shape.number, geometry, base, count);
  }

  /// No part has this shape any more.
  remove(shape: number): void {
    for (const pass of this.all) pass.remove(shape);
  }

  /// Lays the quads into the section plane, past all that stands in `box`.
  setSection(section: Section | null, box: Readonly<Box>): void {
    this.cutPlane.visible = this.outlineErase.visible = section !== null;
    if (!section) return;
    const size = 2 * Math.max(1, box[3] - box[0], box[4] - box[1], box[5] - box[2]);
    const place = [0, 1, 2].map((i) => ((box[i] as number) + (box[i + 3] as number)) / 2);
    const axis = { x: 0, y: 1, z: 2 }[section.axis];
    place[axis] = planeAt(section);
    // The quad's own x and y axes become the two of the plane.
    const [u, v] = [axis === 0 ? 1 : 0, axis === 2 ? 1 : 2];
    for (const { matrixWorld } of [this.cutPlane, this.outlineErase]) {
      const e = matrixWorld.elements;
      e.fill(0);
      e[u] = e[4 + v] = size;
      e[12] = place[0] as number;
      e[13] = place[1] as number;
      e[14] = place[2] as number;
      e[15] = 1;
    }
  }

  clear(): void {
    for (const pass of this.all) pass.clear();
  }

  release(): void {
    this.quad.dispose();
  }
}
