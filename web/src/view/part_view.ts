/// One part on a turntable: with its box, the lengths of its sides, and faint previews of how it may stand.

import { type Affine, apply, type Box, multiply, toTransform, turn } from "./affine";
import { boxLines } from "./box_lines";
import { basisOf, framed, homeAzimuth, homeElevation, project } from "./camera";
import { rgbOfHex } from "./colour";
import { Lines } from "./lines";
import { meshFacts } from "./mesh_facts";
import { onScreen, Tag } from "./overlay";
import { Stage } from "./stage";
import { tokens } from "./tokens";
import type { MeshData, PartView, Size, Theme, ViewCopy } from "./view";

type Stands = "any" | "upright" | "fixed" | "axes";

const boxShare = 0.62;
/// CSS pixels between an edge and its length.
const tagGap = 18;

/// Turns about the part's middle that are shown faint: axis and degrees.
const previews: Readonly<Record<Stands, readonly (readonly [Size, number])[]>> = {
  fixed: [],
  upright: [
    [[0, 0, 1], 60],
    [[0, 0, 1], 120],
  ],
  axes: [
    [[1, 0, 0], 90],
    [[0, 1, 0], 90],
    [[0, 0, 1], 90],
  ],
  any: [
    [[1, 0, 0], 55],
    [[0, 1, 0], 55],
    [[Math.SQRT1_2, Math.SQRT1_2, 0], 90],
  ],
};

/// Shows nothing where the browser has no 3D graphics.
export function createPartView(host: HTMLElement, theme: Theme): PartView {
  return new Turntable(host, theme);
}

class Turntable implements PartView {
  private readonly stage: Stage;
  private readonly edges = new Lines(true);
  private readonly tags: readonly [Tag, Tag, Tag];
  private mesh: MeshData | null = null;
  private box: Box = [-50, -50, 0, 50, 50, 50];
  private colour = "#7d8792";
  private untouched = true;

  constructor(host: HTMLElement, theme: Theme) {
    this.stage = new Stage(host, theme, {
      advance: () => false,
      prepare: (eye) => {
        const colour = tokens(this.stage.theme).edge;
        this.edges.set(this.mesh ? boxLines(this.box, eye, { colour, open: false }) : []);
      },
      drawn: () => this.placeTags(),
      click: () => {},
      doubleClick: () => this.home(true),
      hover: () => {},
      grabbed: () => {
        this.untouched = false;
      },
      resized: () => this.untouched && this.home(false),
      pointAt: () => null,
      lost: () => {},
      shown: () => {},
      paced: () => {},
    });
    this.element.setAttribute("aria-label", "Part in 3D");
    this.stage.addLines(this.edges);
    const { looks } = this.stage.pieces;
    looks.faint = ({ copy }) => copy > 0;
    looks.paint = ({ copy }) => rgbOfHex(copy > 0 ? tokens(this.stage.theme).text2 : this.colour);
    this.tags = [new Tag("", false), new Tag("", false), new Tag("", false)];
    for (const tag of this.tags) this.stage.element.append(tag.element);
    this.paint(theme);
  }

  get element(): HTMLElement {
    return this.stage.element;
  }

  setTheme(theme: Theme): void {
    if (theme === this.stage.theme) return;
    this.paint(theme);
  }

  private paint(theme: Theme): void {
    for (const tag of this.tags) tag.setTheme(theme);
    this.stage.setTheme(theme);
  }

  show(mesh: MeshData | null, scale: number, colour: string, stands: Stands): void {
    const { pieces } = this.stage;
    const fresh = mesh !== this.mesh;
    const before = this.mesh ? this.box : null;
    this.mesh = mesh;
    this.colour = colour;
    if (fresh) pieces.setParts(mesh ? [{ index: 0, name: "", mesh }] : []);
    else pieces.clear();
    if (mesh) {
      const own = meshFacts(mesh).box;
      // The part stands on the ground, in the middle of the table.
      const x = (-scale * (own[0] + own[3])) / 2;
      const y = (-scale * (own[1] + own[4])) / 2;
      const place: Affine = [scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, -scale * own[2]];
      const low = apply(place, [own[0], own[1], own[2]]);
      const high = apply(place, [own[3], own[4], own[5]]);
      this.box = [...low, ...high];
      const centre: Size = [0, 0, high[2] / 2];
      const turns = previews[stands].map(([axis, degrees]) => multiply(turn(axis, degrees, centre), place));
      const copies = [place, ...turns].map(
        (rows, copy): ViewCopy => ({ part: 0, copy, order: copy, transform: toTransform(rows) }),
      );
      pieces.place(copies, false, performance.now());
      high.forEach((v, i) => {
        const length = v - (low[i] as number);
        this.tags[i as 0 | 1 | 2].element.textContent = length.toFixed(1);
      });
      this.stage.ground = this.box;
      const side = Math.max(...high.map((v, i) => v - (low[i] as number)), 1e-3);
      this.stage.controls.nearest = side / 50;
      this.stage.controls.farthest = side * 20;
    }
    pieces.looksChanged(true);
    // A finer mesh of the same part leaves the camera where the user turned it.
    const alike = before?.every((v, i) => Math.abs(v - (this.box[i] as number)) < 0.02 * (this.box[5] + 1)) ?? false;
    if (this.untouched || !alike) this.home(false);
    this.stage.invalidate();
  }

  dispose(): void {
    this.stage.dispose();
  }

  private home(flying: boolean): void {
    const { controls, lens } = this.stage;
    const from = { ...controls.orbit, azimuth: homeAzimuth, elevation: homeElevation };
    const to = framed(from, lens, this.box, boxShare);
    this.untouched = true;
    if (flying) controls.flyTo(to);
    else controls.jumpTo(to);
  }

  /// Each length beside the edge of its kind that the viewer has at the box's rim, where it covers nothing.
  private placeTags(): void {
    const { controls, lens, size } = this.stage;
    const [x0, y0, z0, x1, y1, z1] = this.box;
    const { eye } = basisOf(controls.orbit);
    const nearX = eye[0] > (x0 + x1) / 2 ? x1 : x0;
    const nearY = eye[1] > (y0 + y1) / 2 ? y1 : y0;
    const floor = eye[2] > z0 ? z0 : z1;
    const centre: Size = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2];
    const middleAt = onScreen(controls.orbit, lens, centre, size.width, size.height);
    // Of the two upright edges at the rim, the one on the right.
    const rims: Size[] = [
      [nearX, nearY === y1 ? y0 : y1, centre[2]],
      [nearX === x1 ? x0 : x1, nearY, centre[2]],
    ];
    rims.sort((a, b) => project(controls.orbit, lens, b).x - project(controls.orbit, lens, a).x);
    const places: [Size, Size, Size] = [[centre[0], nearY, floor], [nearX, centre[1], floor], rims[0] as Size];
    places.forEach((p, i) => {
      const at = this.mesh && middleAt ? onScreen(controls.orbit, lens, p, size.width, size.height) : null;
      const tag = this.tags[i as 0 | 1 | 2];
      if (!at || !middleAt) {
        tag.moveTo(null);
        return;
      }
      const away = Math.hypot(at.x - middleAt.x, at.y - middleAt.y) || 1;
      const gap = tagGap / away;
      tag.moveTo({ x: at.x + (at.x - middleAt.x) * gap, y: at.y + (at.y - middleAt.y) * gap });
    });
  }
}
