/// Mouse, touch and keys to camera moves. Left turns, middle or Shift and left moves along, the wheel comes nearer to
/// what is under the pointer; one finger turns, two move along and pinch. The camera itself is maths (camera.ts).

import { between, type Lens, type Orbit, onTargetPlane, panned, rayAt, turned, zoomed } from "./camera";
import { cameraTime, ease, reducedMotion } from "./motion";
import type { Size } from "./view";

export interface ControlEvents {
  /// The camera moves, or something began that moves it with the frames to come.
  moved(): void;
  click(x: number, y: number, add: boolean): void;
  doubleClick(x: number, y: number): void;
  /// The pointer is over the picture with no button held; null: it left.
  hover(at: { x: number; y: number } | null): void;
  /// The user moves the camera, and not the page.
  grabbed(): void;
  /// What is drawn there, for zooming to it.
  pointAt(x: number, y: number): Size | null;
}

/// A press that moves less than this, in CSS pixels, is a click.
const clickSlop = 4;
const turnAPixel = 0.0075;
const keyTurn = Math.PI / 12;
/// ms; what is left of a spin and of a wheel's zoom falls to a third in this time.
const spinTime = 90;
const wheelTime = 45;

interface Held {
  x: number;
  y: number;
}

export class Controls {
  orbit: Orbit;
  lens: Lens;
  nearest = 1;
  farthest = 1e5;
  private held = new Map<number, Held>();
  private pans = false;
  private travelled = 0;
  private spin: { azimuth: number; elevation: number } | null = null;
  private lastTurn = { at: 0, azimuth: 0, elevation: 0 };
  private wheel: { left: number; pivot: Size } | null = null;
  private flight: { from: Orbit; to: Orbit; start: number | null } | null = null;
  private lastFrame: number | null = null;
  private movedAt = -Infinity;
  private readonly leave = new AbortController();

  constructor(
    private readonly element: HTMLElement,
    private readonly events: ControlEvents,
    orbit: Orbit,
    lens: Lens,
  ) {
    this.orbit = orbit;
    this.lens = lens;
    const signal = this.leave.signal;
    element.style.touchAction = "none";
    element.addEventListener("pointerdown", (e) => this.down(e), { signal });
    element.addEventListener("pointermove", (e) => this.move(e), { signal });
    element.addEventListener("pointerup", (e) => this.up(e, true), { signal });
    element.addEventListener("pointercancel", (e) => this.up(e, false), { signal });
    element.addEventListener("pointerleave", () => this.held.size === 0 && events.hover(null), { signal });
    element.addEventListener("wheel", (e) => this.wheeled(e), { signal, passive: false });
    element.addEventListener("keydown", (e) => this.key(e), { signal });
    element.addEventListener("dblclick", (e) => e.button === 0 && events.doubleClick(...this.place(e)), { signal });
    // The middle button would scroll the page.
    element.addEventListener("mousedown", (e) => e.button === 1 && e.preventDefault(), { signal });
  }

  dispose(): void {
    this.leave.abort();
  }

  /// Whether the user holds the picture, or it goes on moving.
  get busy(): boolean {
    return this.held.size > 0 || this.goesOn;
  }

  /// Whether the picture moves at this moment; not while it is only held for `rest` ms.
  isMoving(now: number, rest: number): boolean {
    return this.goesOn || now - this.movedAt < rest;
  }

  private get goesOn(): boolean {
    return this.spin !== null || this.wheel !== null || this.flight !== null;
  }

  /// Goes there within 200 ms; at once for those who want no motion.
  flyTo(to: Orbit): void {
    this.spin = this.wheel = null;
    if (reducedMotion()) {
      this.orbit = to;
      this.flight = null;
    } else {
      this.flight = { from: this.orbit, to, start: null };
    }
    this.events.moved();
  }

  /// Where the camera will be once it rests.
  get destination(): Orbit {
    return this.flight?.to ?? this.orbit;
  }

  jumpTo(orbit: Orbit): void {
    this.orbit = orbit;
    this.spin = this.wheel = this.flight = null;
    this.events.moved();
  }

  /// Moves on to the time of a frame. Says whether the camera goes on moving.
  step(now: number): boolean {
    const passed = this.lastFrame === null ? 16 : Math.min(100, now - this.lastFrame);
    this.lastFrame = now;
    if (this.flight) {
      this.flight.start ??= now;
      const share = (now - this.flight.start) / cameraTime;
      this.orbit = between(this.flight.from, this.flight.to, ease(share));
      if (share >= 1) this.flight = null;
    }
    if (this.spin) {
      this.orbit = turned(this.orbit, this.spin.azimuth * passed, this.spin.elevation * passed);
      const fades = Math.exp(-passed / spinTime);
      this.spin = { azimuth: this.spin.azimuth * fades, elevation: this.spin.elevation * fades };
      if (Math.hypot(this.spin.azimuth, this.spin.elevation) < 2e-5) this.spin = null;
    }
    if (this.wheel) {
      const part = Math.abs(this.wheel.left) < 0.002 ? 1 : 1 - Math.exp(-passed / wheelTime);
      this.zoom(Math.exp(this.wheel.left * part), this.wheel.pivot);
      this.wheel.left *= 1 - part;
      if (part === 1) this.wheel = null;
    }
    if (!this.goesOn) this.lastFrame = null;
    return this.goesOn;
  }

  zoom(factor: number, pivot: Size): void {
    this.orbit = zoomed(this.orbit, factor, pivot, this.nearest, this.farthest);
  }

  /// -1 to 1 across the picture, y up.
  private place(e: MouseEvent): [number, number] {
    const r = this.element.getBoundingClientRect();
    return [
      (2 * (e.clientX - r.left)) / Math.max(1, r.width) - 1,
      1 - (2 * (e.clientY - r.top)) / Math.max(1, r.height),
    ];
  }

  private pivot(x: number, y: number): Size {
    return this.events.pointAt(x, y) ?? onTargetPlane(this.orbit, rayAt(this.orbit, this.lens, x, y));
  }

  private down(e: PointerEvent): void {
    if (e.target instanceof Element && e.target.closest("[data-handle]")) return;
    if (e.button === 2) return;
    this.element.setPointerCapture(e.pointerId);
    if (this.held.size === 0) {
      this.travelled = 0;
      this.pans = e.button === 1 || e.shiftKey;
    }
    this.held.set(e.pointerId, { x: e.clientX, y: e.clientY });
    this.spin = this.wheel = this.flight = null;
    this.lastTurn = { at: 0, azimuth: 0, elevation: 0 };
    this.events.hover(null);
  }

  private move(e: PointerEvent): void {
    const before = this.held.get(e.pointerId);
    if (!before) {
      if (e.pointerType === "mouse" && e.buttons === 0) {
        const [x, y] = this.place(e);
        this.events.hover({ x, y });
      }
      return;
    }
    const dx = e.clientX - before.x;
    const dy = e.clientY - before.y;
    this.travelled += Math.abs(dx) + Math.abs(dy);
    if (this.held.size >= 2) this.pinch(e, before);
    before.x = e.clientX;
    before.y = e.clientY;
    if (this.travelled >= clickSlop) this.movedAt = performance.now();
    if (this.held.size >= 2 || this.travelled < clickSlop) return;
    this.events.grabbed();
    if (this.pans) {
      this.orbit = panned(this.orbit, dx, dy, this.element.clientHeight, this.lens);
    } else {
      const azimuth = -dx * turnAPixel;
      const elevation = dy * turnAPixel;
      this.orbit = turned(this.orbit, azimuth, elevation);
      const passed = Math.max(4, e.timeStamp - this.lastTurn.at);
      this.lastTurn = { at: e.timeStamp, azimuth: azimuth / passed, elevation: elevation / passed };
    }
    this.events.moved();
  }

  /// Two fingers: the middle between them moves along, their distance zooms.
  private pinch(e: PointerEvent, before: Held): void {
    const other = [...this.held].find(([id]) => id !== e.pointerId)?.[1];
    if (!other) return;
    this.events.grabbed();
    const apartBefore = Math.hypot(before.x - other.x, before.y - other.y);
    const apart = Math.hypot(e.clientX - other.x, e.clientY - other.y);
    const r = this.element.getBoundingClientRect();
    const x = (2 * ((e.clientX + other.x) / 2 - r.left)) / Math.max(1, r.width) - 1;
    const y = 1 - (2 * ((e.clientY + other.y) / 2 - r.top)) / Math.max(1, r.height);
    const dx = (e.clientX - before.x) / 2;
    const dy = (e.clientY - before.y) / 2;
    this.orbit = panned(this.orbit, dx, dy, r.height, this.lens);
    const pivot = onTargetPlane(this.orbit, rayAt(this.orbit, this.lens, x, y));
    if (apart > 1 && apartBefore > 1) this.zoom(apartBefore / apart, pivot);
    this.events.moved();
  }

  private up(e: PointerEvent, released: boolean): void {
    if (!this.held.delete(e.pointerId)) return;
    if (this.held.size > 0) {
      // The finger that stays must not click, nor jump.
      this.travelled = clickSlop;
      return;
    }
    if (released && this.travelled < clickSlop) {
      if (e.button === 0) this.events.click(...this.place(e), e.ctrlKey || e.metaKey);
      return;
    }
    const { at, azimuth, elevation } = this.lastTurn;
    const swift = e.timeStamp - at < 40 && Math.hypot(azimuth, elevation) > 4e-4;
    if (released && swift && !this.pans && !reducedMotion()) this.spin = { azimuth, elevation };
    this.events.moved();
  }

  private wheeled(e: WheelEvent): void {
    e.preventDefault();
    const pixels = e.deltaY * (e.deltaMode === 1 ? 33 : e.deltaMode === 2 ? this.element.clientHeight : 1);
    // A pinch on a touchpad comes as a wheel with Ctrl, in much smaller steps.
    const amount = Math.min(1.2, Math.max(-1.2, pixels * (e.ctrlKey ? 0.01 : 0.0016)));
    const pivot = this.wheel?.pivot ?? this.pivot(...this.place(e));
    if (reducedMotion()) this.zoom(Math.exp(amount), pivot);
    else this.wheel = { left: (this.wheel?.left ?? 0) + amount, pivot };
    this.flight = null;
    this.events.grabbed();
    this.events.moved();
  }

  private key(e: KeyboardEvent): void {
    if (e.target !== this.element || e.altKey || e.metaKey) return;
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-keyTurn, 0],
      ArrowRight: [keyTurn, 0],
      ArrowUp: [0, keyTurn],
      ArrowDown: [0, -keyTurn],
    };
    const turn = turns[e.key];
    const to = this.destination;
    if (turn && e.ctrlKey) this.flyTo(turned(to, ...turn));
    else if ((e.key === "+" || e.key === "=") && !e.ctrlKey)
      this.flyTo(zoomed(to, 0.8, to.target, this.nearest, this.farthest));
    else if (e.key === "-" && !e.ctrlKey) this.flyTo(zoomed(to, 1.25, to.target, this.nearest, this.farthest));
    else return;
    this.events.grabbed();
    e.preventDefault();
    e.stopPropagation();
  }
}
