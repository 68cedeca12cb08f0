/// What is drawn into a tray to point at things and to grab: the section's outline with its handle, a path with its
/// arrow, names of copies, and handles to move a copy.

import { type Box, middle } from "./affine";
import { boxLines } from "./box_lines";
import { along, corners, mmAPixel, type Ray, rayAt } from "./camera";
import { type Line, Lines } from "./lines";
import { Handle, onScreen, Tag } from "./overlay";
import { alongLine, axisIndex, facesCut, handleCorner, outline } from "./section";
import type { Stage } from "./stage";
import { tokens } from "./tokens";
import type { Axis, CopyKey, Label, Size, Theme, TrayViewEvents } from "./view";

const axes: readonly Axis[] = ["x", "y", "z"];
const directions: Readonly<Record<Axis, Size>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
/// CSS pixels.
const handleReach = 92;
const arrowLength = 15;
const arrowWidth = 13;
const tagLift = 18;
const tagGap = 8;

interface Drag {
  /// Where the line runs along which is dragged.
  readonly through: Size;
  readonly start: number;
}

export class Guides {
  private readonly hidden = new Lines(true);
  private readonly over = new Lines(false);
  private readonly sectionHandle: Handle;
  private readonly moveHandles = new Map<Axis, Handle>();
  private tags: { readonly tag: Tag; readonly copy: CopyKey; readonly beside: boolean }[] = [];
  private path: readonly Size[] | null = null;
  private moving: CopyKey | null = null;
  private keepOut: readonly Readonly<Box>[] = [];
  private drag: Drag | null = null;
  private moved: Size = [0, 0, 0];
  private theme: Theme = "light";

  constructor(
    private readonly stage: Stage,
    private readonly events: TrayViewEvents,
    private readonly tray: () => Box,
  ) {
    stage.addLines(this.hidden);
    stage.addLines(this.over);
    this.sectionHandle = new Handle("Section", "", {
      drag: (x, y, first) => this.dragSection(x, y, first),
      nudge: (steps) => this.stage.section && this.tellSection(this.stage.section.at + steps),
      done: () => {
        this.drag = null;
      },
    });
    stage.element.append(this.sectionHandle.element);
    for (const axis of axes) {
      const handle = new Handle(`Move along ${axis.toUpperCase()}`, axis.toUpperCase(), {
        drag: (x, y, first) => this.dragCopy(axis, x, y, first),
        nudge: (steps) => events.move?.(scaled(directions[axis], steps), true),
        done: () => {
          if (this.drag) events.move?.(this.moved, true);
          this.drag = null;
        },
      });
      this.moveHandles.set(axis, handle);
      stage.element.append(handle.element);
    }
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    const t = tokens(theme);
    this.sectionHandle.setColours(t.accent, t.rim, t.onAccent);
    for (const [axis, handle] of this.moveHandles) handle.setColours(t.axes[axis], t.rim, t.onAccent);
    for (const { tag } of this.tags) tag.setTheme(theme);
  }

  setKeepOut(boxes: readonly Readonly<Box>[]): void {
    this.keepOut = boxes;
  }

  setLabels(labels: readonly Label[]): void {
    for (const { tag } of this.tags) tag.element.remove();
    this.tags = labels.map(({ copy, text, beside = false }) => {
      const tag = new Tag(text, true);
      tag.setTheme(this.theme);
      this.stage.element.append(tag.element);
      return { tag, copy, beside };
    });
  }

  setMoving(copy: CopyKey | null): void {
    this.moving = copy;
    this.drag = null;
  }

  setPath(points: readonly Size[] | null): void {
    this.path = points;
  }

  /// Edges of what stands in the tray besides copies.
  edgeLines(eye: Size): Line[] {
    const colour = tokens(this.theme).edge;
    return this.keepOut.flatMap((box) => boxLines(box, eye, { colour, open: false })).map((l) => ({ ...l, width: 1 }));
  }

  /// Before a frame.
  update(eye: Size): void {
    const hidden: Line[] = [];
    const over: Line[] = [];
    this.addSection(eye, hidden, over);
    this.addPath(over);
    this.addMoving(over);
    this.hidden.set(hidden);
    this.over.set(over);
  }

  /// After a frame: the page elements.
  place(): void {
    const { section } = this.stage;
    const eye = this.stage.pieces.shared.eye.value;
    if (section && this.events.section) {
      const tray = this.tray();
      const axis = axisIndex[section.axis];
      const inside = section.at >= tray[axis] && section.at <= (tray[axis + 3] as number);
      const corner = handleCorner(section, tray, [eye.x, eye.y, eye.z]);
      this.sectionHandle.moveTo(inside ? this.screen(corner) : null);
      this.sectionHandle.setValue(section.at, tray[axis], tray[axis + 3] as number);
    } else {
      this.sectionHandle.moveTo(null);
    }
    for (const { tag, copy, beside } of this.tags) {
      const box = this.boxOf(copy);
      if (box && beside) {
        tag.moveTo(this.besideBox(box, tag.element.offsetWidth));
        continue;
      }
      const at = box && this.screen([(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, box[5]]);
      tag.moveTo(at ? { x: at.x, y: at.y - tagLift } : null);
    }
    const centre = this.movingCentre();
    for (const [axis, handle] of this.moveHandles) {
      const at = centre && this.screen(this.handleEnd(centre, axis));
      handle.moveTo(at);
      if (centre) handle.setValue(centre[axisIndex[axis]], 0, this.tray()[axisIndex[axis] + 3] as number);
    }
  }

  dispose(): void {
    this.sectionHandle.dispose();
    for (const handle of this.moveHandles.values()) handle.dispose();
    this.setLabels([]);
  }

  private screen(p: Size): { x: number; y: number } | null {
    const { width, height } = this.stage.size;
    return onScreen(this.stage.controls.orbit, this.stage.lens, p, width, height);
  }

  /// The middle of a word of so many pixels that stands to the right of a box.
  private besideBox(box: Readonly<Box>, width: number): { x: number; y: number } | null {
    const places = corners(box).flatMap((corner) => this.screen(corner) ?? []);
    const centre = this.screen(middle(box));
    if (!centre || places.length === 0) return null;
    const right = Math.max(...places.map((place) => place.x)) + tagGap + width / 2;
    return { x: Math.min(right, this.stage.size.width - tagGap - width / 2), y: centre.y };
  }

  private rayAt(x: number, y: number): Ray {
    const { width, height } = this.stage.size;
    return rayAt(this.stage.controls.orbit, this.stage.lens, (2 * x) / width - 1, 1 - (2 * y) / height);
  }

  private boxOf(copy: CopyKey): Box | null {
    const { copies } = this.stage.pieces;
    const slot = copies.slotOf(copy);
    return slot === undefined ? null : copies.boxOf(slot);
  }

  private addSection(eye: Size, hidden: Line[], over: Line[]): void {
    const { section } = this.stage;
    if (!section) return;
    const tray = this.tray();
    const axis = axisIndex[section.axis];
    if (section.at < tray[axis] || section.at > (tray[axis + 3] as number)) return;
    const points = outline(section, tray);
    const colour = tokens(this.theme).accent;
    const seen = facesCut(section, eye);
    points.forEach((from, i) => {
      const to = points[(i + 1) % 4] as Size;
      hidden.push({ from, to, colour, width: 2 });
      over.push({ from, to, colour, width: 2, opacity: seen ? 0.55 : 0.25 });
    });
  }

  private addPath(over: Line[]): void {
    const path = this.path;
    const first = path?.[0];
    const last = path?.[path.length - 1];
    if (!path || !first || !last) return;
    const t = tokens(this.theme);
    const head = arrowLength * this.mm();
    let end = last;
    // A path may rest at its end: the arrow points where it last moved.
    const before = path.filter((p) => distance(p, last) > 1e-6).pop();
    if (before) end = along(last, towards(last, before), Math.min(head, distance(last, before)));
    const points = [...path.slice(0, -1), end];
    for (const [colour, width, opacity] of [
      [t.rim, 4.5, 0.65],
      [t.accent, 2.25, 1],
    ] as const) {
      points.slice(1).forEach((to, i) => {
        over.push({ from: points[i] as Size, to, colour, width, opacity, ...(colour === t.accent ? { dash: 6 } : {}) });
      });
    }
    if (before) over.push({ from: end, to: last, colour: t.accent, width: arrowWidth, endWidth: 0 });
    over.push({ from: first, to: first, colour: t.accent, width: 10 });
    over.push({ from: first, to: first, colour: t.rim, width: 5.5 });
  }

  private addMoving(over: Line[]): void {
    const centre = this.movingCentre();
    if (!centre) return;
    const t = tokens(this.theme);
    for (const axis of axes) {
      const to = this.handleEnd(centre, axis);
      over.push({ from: centre, to, colour: t.rim, width: 5 });
    }
    for (const axis of axes) {
      const to = this.handleEnd(centre, axis);
      over.push({ from: centre, to, colour: t.axes[axis], width: 2.5 });
    }
  }

  private mm(): number {
    return mmAPixel(this.stage.controls.orbit, this.stage.size.height, this.stage.lens);
  }

  private movingCentre(): Size | null {
    const box = this.moving && this.events.move ? this.boxOf(this.moving) : null;
    return box && middle(box);
  }

  private handleEnd(centre: Size, axis: Axis): Size {
    return along(centre, directions[axis], handleReach * this.mm());
  }

  private dragSection(x: number, y: number, first: boolean): void {
    const { section } = this.stage;
    if (!section) return;
    const direction = directions[section.axis];
    const eye = this.stage.pieces.shared.eye.value;
    // The corner stays the same while it is dragged, although another may come nearer.
    const through = first || !this.drag ? handleCorner(section, this.tray(), [eye.x, eye.y, eye.z]) : this.drag.through;
    const ray = this.rayAt(x, y);
    const at = alongLine(through, direction, ray.origin, ray.direction);
    if (at === null) return;
    const axis = axisIndex[section.axis];
    if (first || !this.drag) {
      // Grabbed beside its middle, it must not jump.
      this.drag = { through, start: at };
      return;
    }
    this.tellSection((through[axis] as number) + at - this.drag.start);
  }

  private tellSection(at: number): void {
    const { section } = this.stage;
    if (!section) return;
    const tray = this.tray();
    const axis = axisIndex[section.axis];
    const inside = Math.min(tray[axis + 3] as number, Math.max(tray[axis], at));
    this.events.section?.(Math.round(10 * inside) / 10);
  }

  private dragCopy(axis: Axis, x: number, y: number, first: boolean): void {
    const centre = this.movingCentre();
    if (!centre) return;
    const through = first || !this.drag ? centre : this.drag.through;
    const ray = this.rayAt(x, y);
    const at = alongLine(through, directions[axis], ray.origin, ray.direction);
    if (at === null) return;
    if (first || !this.drag) {
      this.drag = { through, start: at };
      this.moved = [0, 0, 0];
      return;
    }
    this.moved = scaled(directions[axis], Math.round(10 * (at - this.drag.start)) / 10);
    this.events.move?.(this.moved, false);
  }
}

function scaled(d: Size, length: number): Size {
  return [d[0] * length, d[1] * length, d[2] * length];
}

function distance(a: Size, b: Size): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

function towards(from: Size, to: Size): Size {
  const d = distance(from, to);
  return [(to[0] - from[0]) / d, (to[1] - from[1]) / d, (to[2] - from[2]) / d];
}
