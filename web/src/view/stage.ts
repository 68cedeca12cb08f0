/// What both views share: the canvas and its frames, the camera, light and shadow, and what happens when the graphics
/// card takes the drawing away. A frame is drawn when something changed, and then only.

import { Matrix4, type Object3D, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { type Box, grow, isEmpty } from "./affine";
import { backgroundStyle, paintBackground } from "./background";
import { basisOf, depthRange, homeAzimuth, homeElevation, type Lens, lensView, mmAPixel, type Orbit } from "./camera";
import { Compose, type FrameSize, outlineInputs } from "./compose";
import { Controls } from "./controls";
import { Daylight } from "./daylight";
import type { Lines } from "./lines";
import { frustumOf } from "./lists";
import { Gizmo } from "./overlay";
import { Pace } from "./pace";
import { Pieces } from "./pieces";
import { hatchStep, planeOf } from "./section";
import { tokens } from "./tokens";
import { noPlane, setLights } from "./uniforms";
import type { Section, Size, Speed, Theme } from "./view";

export interface StageEvents {
  /// Before a frame: may move the camera. Says whether it wants another frame.
  advance(now: number): boolean;
  /// Then: brings lines and the like up to the camera.
  prepare(eye: Size): void;
  /// After a frame: puts page elements where they belong.
  drawn(): void;
  /// Copies are in the picture for the first time.
  shown(): void;
  /// It was measured anew how fast the machine draws.
  paced(): void;
  click(x: number, y: number, add: boolean): void;
  doubleClick(x: number, y: number): void;
  hover(at: { x: number; y: number } | null): void;
  grabbed(): void;
  /// The picture has a new shape.
  resized(): void;
  pointAt(x: number, y: number): Size | null;
  lost(lost: boolean): void;
}

/// More device pixels than this a CSS pixel are not seen, but paid for.
const mostRatio = 2;
/// Pixels between hatch lines.
const hatchPixels = 7;
/// ms after its last change that the section counts as moving.
const sectionRest = 160;
/// ms after the last coarse frame that the picture is drawn in full.
const coarseRest = 270;
/// ms that a new picture is on the screen before what makes it finer is drawn; and that copies are waited for: what an
/// empty tray takes would only delay them.
const newRest = 60;
const emptyRest = 2500;
/// ms of work on normals, and between two stretches of it.
const smoothStretch = 8;
const smoothPause = 20;

export class Stage {
  readonly element = document.createElement("div");
  readonly scene = new Scene();
  readonly pieces: Pieces;
  readonly controls: Controls;
  theme: Theme;
  section: Section | null = null;
  /// What is always in the picture, whether copies stand there or not.
  ground: Readonly<Box> = [0, 0, 0, 1, 1, 1];
  drawCalls = 0;

  private readonly canvas = document.createElement("canvas");
  private readonly renderer: WebGLRenderer | null;
  private readonly camera = new PerspectiveCamera();
  private readonly inputs = outlineInputs();
  private readonly compose = new Compose(this.inputs);
  private readonly daylight: Daylight;
  private readonly gizmo = new Gizmo();
  private readonly observer: ResizeObserver;
  private readonly pace = new Pace();
  private readonly leave = new AbortController();
  private readonly lines: Lines[] = [];
  private width = 0;
  private height = 0;
  private ratio = 1;
  private request = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private smoothing: ReturnType<typeof setTimeout> | undefined;
  private timerAt = Infinity;
  private sectionAt = -Infinity;
  private lostNow = false;
  private shown = false;
  private readonly madeAt = performance.now();

  constructor(
    host: HTMLElement,
    theme: Theme,
    private readonly events: StageEvents,
  ) {
    this.theme = theme;
    Object.assign(this.element.style, { position: "absolute", inset: "0", overflow: "hidden", userSelect: "none" });
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "application");
    Object.assign(this.canvas.style, {
      position: "absolute",
      inset: "0",
      width: "100%",
      height: "100%",
      display: "block",
    });
    this.element.append(this.canvas, this.gizmo.element);
    // The browser's own ring would lie outside, where the host cuts it off.
    this.element.style.outlineOffset = "-2px";
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.append(this.element);

    this.pieces = new Pieces(this.inputs);
    this.daylight = new Daylight(this.pieces);
    this.scene.matrixWorldAutoUpdate = false;
    this.scene.add(this.daylight.sun.ground, this.pieces.passes.picture);
    this.camera.matrixAutoUpdate = false;
    this.renderer = makeRenderer(this.canvas);

    const orbit: Orbit = { target: [0, 0, 0], distance: 1000, azimuth: homeAzimuth, elevation: homeElevation };
    this.controls = new Controls(
      this.element,
      {
        moved: () => this.invalidate(),
        click: (x, y, add) => events.click(x, y, add),
        doubleClick: (x, y) => events.doubleClick(x, y),
        hover: (at) => events.hover(at),
        grabbed: () => events.grabbed(),
        pointAt: (x, y) => events.pointAt(x, y),
      },
      orbit,
      { view: lensView, aspect: 1 },
    );

    const signal = this.leave.signal;
    this.canvas.addEventListener("webglcontextlost", () => this.setLost(true), { signal });
    this.canvas.addEventListener("webglcontextrestored", () => this.setLost(false), { signal });
    this.observer = new ResizeObserver(() => this.resized());
    this.observer.observe(this.element);
    this.setTheme(theme);
  }

  /// False where the browser has no 3D graphics: then nothing is ever drawn.
  get canDraw(): boolean {
    return this.renderer !== null;
  }

  get lens(): Lens {
    return this.controls.lens;
  }

  get size(): { readonly width: number; readonly height: number } {
    return { width: this.width, height: this.height };
  }

  /// How fast so many triangles are drawn, as far as is known.
  draws(triangles: number): Speed {
    return this.pace.draws(triangles);
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.pieces.looks.theme = theme;
    this.pieces.looksChanged(false);
    this.daylight.sun.setTheme(theme);
    this.gizmo.setTheme(theme);
    setLights(this.pieces.shared, theme);
    this.element.style.background = backgroundStyle(theme);
    this.invalidate();
  }

  setSection(section: Section | null): void {
    const before = this.section;
    if (section?.axis === before?.axis && section?.at === before?.at && section?.flipped === before?.flipped) return;
    if (section && before) this.sectionAt = performance.now();
    this.section = section;
    this.pieces.setSection(section);
    this.pieces.shared.plane.value.set(...(section ? planeOf(section) : noPlane));
    this.invalidate();
  }

  /// Drawn after the copies, in this order.
  add(object: Object3D): void {
    this.scene.add(object);
  }

  addLines(lines: Lines): void {
    this.lines.push(lines);
    this.scene.add(lines.mesh);
  }

  /// All that there is to see.
  bounds(): Box {
    const box = [...this.ground] as Box;
    const copies = this.pieces.bounds();
    if (!isEmpty(copies)) grow(box, copies);
    return box;
  }

  invalidate(): void {
    if (this.request === 0) this.request = requestAnimationFrame((now) => this.onFrame(now));
  }

  /// At once, whether or not anything changed.
  drawNow(): void {
    this.draw(performance.now(), false);
  }

  /// The background is the page's, so it is painted here.
  async picture(width: number, height: number): Promise<Blob> {
    const page = document.createElement("canvas");
    page.width = width;
    page.height = height;
    const context = page.getContext("2d");
    if (!context) throw new Error("The picture could not be drawn: the page has no memory for it.");
    paintBackground(context, width, height, this.theme);
    if (this.renderer && !this.lostNow) {
      const lens = this.controls.lens;
      const aspect = width / height;
      // A narrower picture still shows all that the view shows from left to right.
      const wider = Math.max(1, lens.aspect / aspect);
      this.controls.lens = { view: 2 * Math.atan(Math.tan(lens.view / 2) * wider), aspect };
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(width, height, false);
      const now = performance.now();
      this.step(now);
      this.drawAt(now, { width, height, samples: 4 }, height / Math.max(1, this.height), false);
      context.drawImage(this.canvas, 0, 0);
      this.controls.lens = lens;
      this.compose.release();
      this.resized();
    }
    return new Promise((resolve, reject) => {
      page.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error("The picture could not be written."));
      }, "image/png");
    });
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.request = -1;
    clearTimeout(this.timer);
    clearTimeout(this.smoothing);
    this.observer.disconnect();
    this.leave.abort();
    this.controls.dispose();
    this.pieces.dispose();
    this.daylight.dispose();
    for (const lines of this.lines) lines.dispose();
    this.compose.dispose();
    this.renderer?.dispose();
    // Browsers keep few contexts alive and take the oldest away; this one is not needed any more.
    this.renderer?.forceContextLoss();
    this.element.remove();
  }

  private setLost(lost: boolean): void {
    this.lostNow = lost;
    if (lost) {
      // What three.js believes to be on the card is gone; what is drawn again is brought there again.
      this.daylight.forget();
      this.pieces.release();
      for (const lines of this.lines) lines.dispose();
      this.compose.dispose();
    } else {
      this.pieces.looksChanged(true);
      this.invalidate();
    }
    this.events.lost(lost);
  }

  private resized(): void {
    this.width = this.element.clientWidth;
    this.height = this.element.clientHeight;
    this.ratio = Math.min(mostRatio, globalThis.devicePixelRatio || 1);
    if (this.width === 0 || this.height === 0) return;
    this.controls.lens = { view: lensView, aspect: this.width / this.height };
    this.renderer?.setPixelRatio(this.ratio);
    this.renderer?.setSize(this.width, this.height, false);
    this.events.resized();
    // A canvas of a new size is empty: drawn before the page is shown, it does not flicker.
    this.draw(performance.now(), false);
  }

  private onFrame(now: number): void {
    this.request = 0;
    if (Math.min(mostRatio, globalThis.devicePixelRatio || 1) !== this.ratio) this.resized();
    this.draw(now, this.isMoving(now));
  }

  /// Whether frames follow each other because something moves: the camera, the section, copies.
  private isMoving(now: number): boolean {
    const { pieces } = this;
    return (
      this.controls.isMoving(now, this.pace.rest) ||
      now - this.sectionAt < sectionRest ||
      pieces.anyResting ||
      pieces.isLanding(now)
    );
  }

  private draw(now: number, moving: boolean): void {
    if (!this.renderer || this.lostNow || this.width === 0 || this.height === 0) return;
    this.pieces.setMoving(moving);
    const goesOn = this.step(now);
    const { triangles } = this.pieces;
    const full = { width: Math.round(this.width * this.ratio), height: Math.round(this.height * this.ratio) };
    const awaits = this.pieces.copies.size === 0 && now - this.madeAt < emptyRest;
    const isNew = awaits || this.pace.isNew(triangles);
    const quality = this.pace.quality(moving, triangles);
    const size = {
      width: Math.max(1, Math.round(full.width * quality.scale)),
      height: Math.max(1, Math.round(full.height * quality.scale)),
      // Twice as fine a screen needs no more than half the samples, and they would take much memory.
      samples: this.ratio >= 1.5 ? Math.min(quality.samples, 2) : quality.samples,
    };
    const timed = !awaits && this.pace.wantsTime(now, moving, triangles);
    const before = performance.now();
    this.drawAt(now, size, this.ratio, isNew);
    // Reading a pixel waits until the frame is drawn.
    const gl = this.renderer.getContext();
    if (timed) gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    if (!awaits) this.pace.drawn(now, timed ? performance.now() - before : null, moving, triangles);
    if (!this.shown && this.pieces.copies.size > 0) {
      this.shown = true;
      performance.mark("copies drawn"); // what bench/page.mjs waits for
      this.events.shown();
    }
    if (timed) this.events.paced();
    if (isNew && !awaits) this.later(newRest);
    else if (goesOn) this.invalidate();
    else if (awaits) this.later(emptyRest);
    else if (moving || this.pace.quality(false, triangles) !== quality)
      this.later(Math.max(coarseRest, this.pace.rest));
    if (this.pieces.isRough && this.smoothing === undefined)
      this.smoothing = setTimeout(() => this.smooth(), smoothPause);
  }

  /// Round faces get their normals while nothing else happens.
  private smooth(): void {
    this.smoothing = undefined;
    if (!this.isMoving(performance.now())) this.pieces.smoothSome(smoothStretch);
    if (!this.pieces.isRough) this.invalidate();
    else this.smoothing = setTimeout(() => this.smooth(), smoothPause);
  }

  /// Brings camera and copies up to the moment. Says whether another frame is wanted.
  private step(now: number): boolean {
    const moves = this.controls.step(now);
    const wants = this.events.advance(now);
    const { eye } = basisOf(this.controls.orbit);
    this.events.prepare(eye);
    this.placeCamera(this.bounds());
    this.pieces.shared.eye.value.set(...eye);
    const all = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    const fades = this.pieces.update(now, frustumOf(all.elements), eye);
    return moves || wants || fades;
  }

  /// `plain`: without the light that is worked out from what stands.
  private drawAt(now: number, size: FrameSize, ratio: number, plain: boolean): void {
    const renderer = this.renderer as WebGLRenderer;
    const box = this.bounds();
    const { eye } = basisOf(this.controls.orbit);
    this.pieces.shared.hatchStep.value = hatchStep(mmAPixel(this.controls.orbit, this.height, this.lens), hatchPixels);
    if (plain) this.daylight.clear(renderer, box);
    const light = plain ? null : this.daylight.update(renderer, now, box, this.section, this.pace.cost);
    if (light !== null) this.later(light);
    if (this.pieces.anyResting) this.later(120);
    renderer.info.autoReset = false;
    renderer.info.reset();
    // From below, the shadow would lie over what casts it.
    this.daylight.sun.showGround(eye[2] > 0);
    const { accent, mark } = this.pieces.looks.outlineColour;
    this.compose.setColours(accent, mark, tokens(this.theme).rim);
    const { through } = this.pieces.looks;
    this.compose.setThrough(through.accent, through.mark);
    const side = Math.max(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
    const outlines = this.pieces.hasOutlines ? this.pieces.passes.outlines : null;
    const factor = size.width / Math.max(1, renderer.domElement.width);
    for (const lines of this.lines) lines.setScreen(size.width, size.height, ratio * factor);
    this.compose.render(renderer, this.scene, outlines, this.camera, size, ratio, 0.012 * side);
    this.drawCalls = renderer.info.render.calls;
    this.gizmo.update(this.controls.orbit);
    this.events.drawn();
  }

  private placeCamera(box: Box): void {
    const { right, up, back, eye } = basisOf(this.controls.orbit);
    const { near, far } = depthRange(this.controls.orbit, withShadow(box));
    const { camera } = this;
    camera.matrix.makeBasis(new Vector3(...right), new Vector3(...up), new Vector3(...back)).setPosition(...eye);
    camera.matrixWorldNeedsUpdate = true;
    camera.fov = (this.lens.view * 180) / Math.PI;
    camera.aspect = this.lens.aspect;
    camera.near = near;
    camera.far = far;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
  }

  /// A frame in so many ms, or sooner where another is waited for.
  private later(ms: number): void {
    const due = performance.now() + Math.max(4, ms);
    if (due >= this.timerAt) return;
    clearTimeout(this.timer);
    this.timerAt = due;
    this.timer = setTimeout(() => {
      this.timerAt = Infinity;
      this.invalidate();
    }, due - performance.now());
  }
}

function makeRenderer(canvas: HTMLCanvasElement): WebGLRenderer | null {
  try {
    const renderer = new WebGLRenderer({ canvas, alpha: true, antialias: false, depth: false, stencil: false });
    renderer.setClearColor(0x000000, 0);
    // All passes stand in the scene in the order in which they are drawn.
    renderer.sortObjects = false;
    return renderer;
  } catch {
    return null;
  }
}

/// With room for the shadow on the ground, on the far side from the sun.
function withShadow(box: Box): Box {
  const side = Math.max(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
  return [box[0] - 0.3 * side, box[1] - 0.3 * side, Math.min(0, box[2]), box[3] + side, box[4] + side, box[5]];
}
