/// The view of a tray: what the page sets is passed on to the copies and their looks, and what the user does with the
/// mouse is told to the page.

import { type Box, emptyBox, grow, isEmpty, middle } from "./affine";
import { boxLines } from "./box_lines";
import { along, framed, type Orbit, rayAt } from "./camera";
import { boxOfCorners, Glass } from "./glass";
import { Guides } from "./guides";
import { Lines } from "./lines";
import { reducedMotion } from "./motion";
import { partColour } from "./palette";
import { type Hit, pick } from "./pick";
import { sides } from "./sides";
import { Stage } from "./stage";
import { tokens } from "./tokens";
import type {
  Colouring,
  CopyKey,
  Label,
  MeshData,
  Section,
  Side,
  Size,
  Speed,
  Theme,
  TrayView,
  TrayViewEvents,
  ViewCopy,
  ViewPart,
} from "./view";

/// Of the picture's width or height: room stays for the bars that float over it.
const trayShare = 0.8;
const copyShare = 0.45;
/// Upright edges of a tray without a ceiling, in relation to its longer side.
const openHeight = 0.8;
/// ms; a camera that follows is a third of its way behind after this.
const followTime = 110;

/// Throws an Error where the browser has no 3D graphics.
export function createTrayView(host: HTMLElement, events: TrayViewEvents, theme: Theme): TrayView {
  const tray = new Tray(host, events, theme);
  if (tray.canDraw) return tray;
  tray.dispose();
  throw new Error("This browser draws no 3D graphics.");
}

class Tray implements TrayView {
  private readonly stage: Stage;
  private readonly guides: Guides;
  private readonly edges = new Lines(true);
  private readonly container: Glass;
  private readonly keepOut: Glass;
  private size: readonly [number, number, number | null] = [100, 100, 100];
  private surround: Box | null = null;
  private followed: readonly CopyKey[] | null = null;
  private followedAt: number | null = null;
  /// The camera shows the whole tray and has not been moved since: it goes on to when the view changes its shape.
  private showsAll = true;
  private hovered: { x: number; y: number } | null = null;
  private hoverRequest = 0;
  private hoveredSlot: number | null = null;

  constructor(
    host: HTMLElement,
    private readonly events: TrayViewEvents,
    theme: Theme,
  ) {
    this.stage = new Stage(host, theme, {
      advance: (now) => this.follow(now),
      prepare: (eye) => this.prepare(eye),
      drawn: () => this.guides.place(),
      click: (x, y, add) => this.clicked(x, y, add),
      doubleClick: (x, y) => this.doubleClicked(x, y),
      hover: (at) => this.hover(at),
      grabbed: () => {
        this.showsAll = false;
      },
      resized: () => {
        if (this.showsAll) this.stage.controls.jumpTo(this.whole());
      },
      pointAt: (x, y) => this.hit(x, y)?.point ?? null,
      shown: () => events.shown?.(),
      paced: () => events.paced?.(),
      lost: (lost) => {
        if (lost) this.releaseGlass();
        events.lost?.(lost);
      },
    });
    this.element.setAttribute("aria-label", "Tray in 3D");
    const eye = this.stage.pieces.shared.eye;
    this.container = new Glass(eye, 0.05, 0.4);
    this.keepOut = new Glass(eye, 0.16, 0.3);
    this.stage.add(this.container.mesh);
    this.stage.add(this.keepOut.mesh);
    this.stage.addLines(this.edges);
    this.guides = new Guides(this.stage, events, () => this.trayBox());
    this.paint(theme);
    this.setTray(this.size);
  }

  get element(): HTMLElement {
    return this.stage.element;
  }

  get canDraw(): boolean {
    return this.stage.canDraw;
  }

  get statistics() {
    const { pieces, drawCalls } = this.stage;
    return { copies: pieces.copies.size, triangles: pieces.triangles, drawCalls };
  }

  setTheme(theme: Theme): void {
    if (theme === this.stage.theme) return;
    this.paint(theme);
  }

  private paint(theme: Theme): void {
    this.container.setColour(tokens(theme).glass);
    this.keepOut.setColour(tokens(theme).edge);
    this.guides.setTheme(theme);
    this.stage.setTheme(theme);
  }

  setTray(size: readonly [number, number, number | null], container?: MeshData, keepOut: readonly Size[][] = []): void {
    this.size = size;
    this.container.setContainer(container ?? null);
    const boxes = keepOut.filter((corners) => corners.length > 0).map(boxOfCorners);
    this.keepOut.setBoxes(boxes);
    this.guides.setKeepOut(boxes);
    this.stage.ground = this.trayBox();
    this.stage.pieces.shadowsDirty = true;
    const side = Math.max(...this.trayBox());
    this.stage.controls.nearest = side / 200;
    this.stage.controls.farthest = side * 12;
    this.showsAll = true;
    this.stage.controls.jumpTo(this.whole());
  }

  setParts(parts: readonly ViewPart[]): void {
    this.stage.pieces.setParts(parts);
    this.stage.invalidate();
  }

  refine(meshes: ReadonlyMap<number, MeshData>, keep = false): void {
    this.stage.pieces.refine(meshes, keep);
    this.stage.invalidate();
  }

  draws(triangles: number): Speed {
    return this.stage.draws(triangles);
  }

  clear(): void {
    this.stage.pieces.clear();
    this.stage.invalidate();
  }

  place(copies: readonly ViewCopy[], landing = false): void {
    this.stage.pieces.place(copies, landing, performance.now());
    this.stage.invalidate();
  }

  remove(copies: readonly CopyKey[]): void {
    this.stage.pieces.remove(copies);
    this.stage.invalidate();
  }

  setColouring(colouring: Colouring): void {
    if (colouring === this.stage.pieces.looks.colouring) return;
    this.stage.pieces.looks.colouring = colouring;
    this.looksChanged(false);
  }

  legend() {
    this.stage.pieces.measure();
    return this.stage.pieces.looks.legend();
  }

  setSection(section: Section | null): void {
    this.stage.setSection(section);
  }

  setSelected(copies: readonly CopyKey[]): void {
    if (this.stage.pieces.looks.select(copies)) this.looksChanged(false);
  }

  setHidden(hidden: (copy: CopyKey) => boolean): void {
    this.stage.pieces.looks.hidden = hidden;
    this.looksChanged(true);
  }

  setFaint(faint: ((copy: CopyKey) => boolean) | null): void {
    this.stage.pieces.looks.faint = faint;
    this.looksChanged(true);
  }

  setMarked(copies: readonly CopyKey[], othersPale: boolean, mark: "warn" | "bad" = "warn"): void {
    if (this.stage.pieces.looks.markThese(copies, othersPale, mark)) this.looksChanged(false);
  }

  setLocked(copies: readonly CopyKey[]): void {
    if (this.stage.pieces.looks.lock(copies)) this.looksChanged(false);
  }

  setLeaving(copies: readonly CopyKey[], ownColour = false): void {
    if (this.stage.pieces.looks.leave(copies, ownColour)) this.looksChanged(false);
  }

  setLabels(labels: readonly Label[]): void {
    this.guides.setLabels(labels);
    this.stage.invalidate();
  }

  setMoving(copy: CopyKey | null): void {
    this.guides.setMoving(copy);
    this.stage.invalidate();
  }

  setPath(points: readonly Size[] | null): void {
    this.guides.setPath(points);
    this.stage.invalidate();
  }

  setFollowed(copies: readonly CopyKey[] | null): void {
    this.followed = copies;
    this.followedAt = null;
    this.stage.invalidate();
  }

  setSurround(corners: readonly [Size, Size] | null): void {
    const before = this.surround?.join();
    this.surround = corners && boxOfCorners(corners);
    if (this.surround?.join() !== before && this.showsAll) this.stage.controls.flyTo(this.whole());
  }

  frame(copies: readonly CopyKey[] | null): void {
    const box = copies ? this.boxOf(copies) : emptyBox();
    this.showsAll = isEmpty(box);
    const { controls, lens } = this.stage;
    controls.flyTo(
      this.showsAll ? this.whole(controls.destination) : framed(controls.destination, lens, box, copyShare),
    );
  }

  look(side: Side): void {
    const { controls } = this.stage;
    const turned = { ...controls.destination, ...sides[side] };
    controls.flyTo(this.showsAll || side === "home" ? this.whole(turned) : turned);
    if (side === "home") this.showsAll = true;
  }

  colourOf(part: number): string {
    return partColour(part, this.stage.theme);
  }

  picture(width: number, height: number): Promise<Blob> {
    return this.stage.picture(width, height);
  }

  drawNow(): void {
    this.stage.drawNow();
  }

  dispose(): void {
    cancelAnimationFrame(this.hoverRequest);
    this.guides.dispose();
    this.releaseGlass();
    this.stage.dispose();
  }

  private releaseGlass(): void {
    this.container.dispose();
    this.keepOut.dispose();
  }

  private looksChanged(shadows: boolean): void {
    this.stage.pieces.looksChanged(shadows);
    this.stage.invalidate();
  }

  /// Without a ceiling it reaches as high as the copies do, and at least so that it looks like a tray.
  private trayBox(): Box {
    const [x, y, z] = this.size;
    if (z !== null) return [0, 0, 0, x, y, z];
    const copies = this.stage.pieces.bounds();
    return [0, 0, 0, x, y, Math.max(openHeight * Math.max(x, y), isEmpty(copies) ? 0 : 1.1 * copies[5])];
  }

  private boxOf(copies: readonly CopyKey[]): Box {
    const box = emptyBox();
    const store = this.stage.pieces.copies;
    for (const copy of copies) {
      const slot = store.slotOf(copy);
      if (slot !== undefined) grow(box, store.boxOf(slot));
    }
    return box;
  }

  private whole(from: Orbit = this.stage.controls.orbit): Orbit {
    const box = this.trayBox();
    if (this.surround) grow(box, this.surround);
    return framed(from, this.stage.lens, box, trayShare);
  }

  private prepare(eye: Size): void {
    this.stage.ground = this.trayBox();
    const colour = tokens(this.stage.theme).edge;
    this.edges.set([
      ...boxLines(this.trayBox(), eye, { colour, open: this.size[2] === null }),
      ...this.guides.edgeLines(eye),
    ]);
    this.guides.update(eye);
  }

  /// Says whether the camera is still behind.
  private follow(now: number): boolean {
    const box = this.followed ? this.boxOf(this.followed) : null;
    const { controls, lens } = this.stage;
    if (!box || isEmpty(box) || controls.busy) {
      this.followedAt = null;
      return false;
    }
    const passed = this.followedAt === null ? 16 : Math.min(100, now - this.followedAt);
    const { orbit } = controls;
    const to = middle(box);
    const way: Size = [to[0] - orbit.target[0], to[1] - orbit.target[1], to[2] - orbit.target[2]];
    const near = Math.hypot(...way) < (orbit.distance * Math.tan(lens.view / 2)) / 1000;
    const share = near || reducedMotion() ? 1 : 1 - Math.exp(-passed / followTime);
    controls.orbit = { ...orbit, target: along(orbit.target, way, share) };
    this.showsAll = false;
    this.followedAt = share === 1 ? null : now;
    return share !== 1;
  }

  private hit(x: number, y: number): Hit | null {
    const { pieces, controls, lens, section } = this.stage;
    const pickable = {
      slots: pieces.pickable(),
      boxes: pieces.copies.boxes,
      rows: pieces.copies.rows,
      meshOf: (slot: number) => pieces.meshOf(slot),
    };
    return pick(rayAt(controls.orbit, lens, x, y), pickable, section);
  }

  private clicked(x: number, y: number, add: boolean): void {
    const hit = this.hit(x, y);
    this.events.select(hit ? this.stage.pieces.copies.keyOf(hit.slot) : null, add);
  }

  private doubleClicked(x: number, y: number): void {
    const hit = this.hit(x, y);
    this.frame(hit ? [this.stage.pieces.copies.keyOf(hit.slot)] : null);
  }

  /// Asked at most once a frame, however fast the pointer is.
  private hover(at: { x: number; y: number } | null): void {
    if (!this.events.hover) return;
    this.hovered = at;
    if (this.hoverRequest === 0) {
      this.hoverRequest = requestAnimationFrame(() => {
        this.hoverRequest = 0;
        this.tellHovered();
      });
    }
  }

  private tellHovered(): void {
    const slot = this.hovered ? (this.hit(this.hovered.x, this.hovered.y)?.slot ?? null) : null;
    if (slot === this.hoveredSlot) return;
    this.hoveredSlot = slot;
    this.element.style.cursor = slot === null ? "" : "pointer";
    this.events.hover?.(slot === null ? null : this.stage.pieces.copies.keyOf(slot));
  }
}
