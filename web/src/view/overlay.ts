/// What lies over the drawing as page elements, because text and what can be grabbed are theirs: the axes, labels, and
/// handles to drag. Styled by script: the page's security policy allows no style attributes.

import { basisOf, type Lens, type Orbit, project } from "./camera";
import { tokens } from "./tokens";
import type { Axis, Size, Theme } from "./view";

const svgName = "http://www.w3.org/2000/svg";
const gizmoSize = 64;

function svg<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Record<string, string | number>,
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(svgName, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}

/// Which way the axes run, in the lower right corner.
export class Gizmo {
  readonly element: SVGSVGElement;
  private readonly arms = new Map<Axis, { line: SVGLineElement; text: SVGTextElement }>();
  private readonly ground: SVGCircleElement;
  private last = "";

  constructor() {
    this.element = svg("svg", { width: gizmoSize, height: gizmoSize, "aria-hidden": "true" });
    Object.assign(this.element.style, { position: "absolute", right: "12px", bottom: "12px", pointerEvents: "none" });
    // Copies may lie behind it.
    this.ground = svg("circle", { cx: gizmoSize / 2, cy: gizmoSize / 2, r: gizmoSize / 2, "fill-opacity": 0.55 });
    this.element.append(this.ground);
    for (const axis of ["x", "y", "z"] as const) {
      const line = svg("line", { "stroke-width": 1.75, "stroke-linecap": "round" });
      const text = svg("text", { "font-size": 11, "text-anchor": "middle", "dominant-baseline": "central" });
      text.textContent = axis.toUpperCase();
      this.element.append(line, text);
      this.arms.set(axis, { line, text });
    }
  }

  setTheme(theme: Theme): void {
    const t = tokens(theme);
    this.ground.setAttribute("fill", t.view2);
    for (const [axis, { line, text }] of this.arms) {
      line.setAttribute("stroke", t.axes[axis]);
      text.setAttribute("fill", t.text2);
    }
  }

  update(orbit: Orbit): void {
    const { right, up, back } = basisOf(orbit);
    const key = `${orbit.azimuth.toFixed(4)} ${orbit.elevation.toFixed(4)}`;
    if (key === this.last) return;
    this.last = key;
    const middle = gizmoSize / 2;
    const arms = [...this.arms].map(([axis, arm], i) => ({ ...arm, axis, depth: back[i] as number, i }));
    // The arm that points at the viewer lies over the others.
    arms.sort((a, b) => a.depth - b.depth);
    for (const { line, text, i } of arms) {
      const x = right[i] as number;
      const y = -(up[i] as number);
      const at = (r: number, v: number) => (middle + r * v).toFixed(2);
      line.setAttribute("x1", String(middle));
      line.setAttribute("y1", String(middle));
      line.setAttribute("x2", at(19, x));
      line.setAttribute("y2", at(19, y));
      text.setAttribute("x", at(26, x));
      text.setAttribute("y", at(26, y));
      // An arm that points at the viewer or away has no room for its letter.
      text.setAttribute("visibility", Math.hypot(x, y) < 0.3 ? "hidden" : "visible");
      this.element.append(line, text);
    }
  }
}

/// A word at a place in the tray.
export class Tag {
  readonly element = document.createElement("div");

  constructor(
    text: string,
    private readonly boxed: boolean,
  ) {
    this.element.textContent = text;
    Object.assign(this.element.style, {
      position: "absolute",
      left: "0",
      top: "0",
      pointerEvents: "none",
      whiteSpace: "nowrap",
      fontSize: "12px",
      lineHeight: "20px",
      fontVariantNumeric: "tabular-nums",
      willChange: "transform",
      // Out of sight until it has its place.
      transform: "translate(-9999px, 0)",
    });
    if (boxed) {
      Object.assign(this.element.style, {
        padding: "0 6px",
        borderRadius: "4px",
        borderWidth: "1px",
        borderStyle: "solid",
      });
    }
  }

  setTheme(theme: Theme): void {
    const t = tokens(theme);
    this.element.style.color = this.boxed ? t.text : t.text2;
    if (!this.boxed) return;
    this.element.style.background = t.surface;
    this.element.style.borderColor = t.line;
  }

  /// Its middle in CSS pixels; null: not to be seen.
  moveTo(at: { x: number; y: number } | null): void {
    this.element.style.display = at ? "block" : "none";
    if (at) {
      this.element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px) translate(-50%, -50%)`;
    }
  }
}

export interface HandleEvents {
  /// The pointer holds it, at this place in CSS pixels of the view.
  drag(x: number, y: number, first: boolean): void;
  /// Arrow keys, in steps; with Shift ten at once.
  nudge(steps: number): void;
  done(): void;
}

/// A round thing to drag: large enough for a finger, small to the eye.
export class Handle {
  readonly element = document.createElement("div");
  private readonly knob = document.createElement("div");
  private readonly leave = new AbortController();

  constructor(label: string, letter: string, events: HandleEvents) {
    const { element, knob } = this;
    const signal = this.leave.signal;
    element.dataset.handle = "";
    element.tabIndex = 0;
    element.setAttribute("role", "slider");
    element.setAttribute("aria-label", label);
    Object.assign(element.style, {
      position: "absolute",
      left: "0",
      top: "0",
      width: "32px",
      height: "32px",
      display: "none",
      cursor: "grab",
      touchAction: "none",
      borderRadius: "16px",
    });
    const size = letter ? 18 : 14;
    Object.assign(knob.style, {
      position: "absolute",
      left: `${16 - size / 2}px`,
      top: `${16 - size / 2}px`,
      width: `${size}px`,
      height: `${size}px`,
      boxSizing: "border-box",
      borderRadius: "50%",
      borderWidth: "2px",
      borderStyle: "solid",
      textAlign: "center",
      fontSize: "10px",
      lineHeight: "14px",
      fontWeight: "600",
      boxShadow: "0 1px 3px rgba(16, 24, 40, .35)",
    });
    knob.textContent = letter;
    element.append(knob);

    let active = false;
    const place = (e: PointerEvent): [number, number] => {
      const r = (element.parentElement ?? element).getBoundingClientRect();
      return [e.clientX - r.left, e.clientY - r.top];
    };
    element.addEventListener(
      "pointerdown",
      (e) => {
        if (e.button !== 0) return;
        e.stopPropagation();
        element.setPointerCapture(e.pointerId);
        element.style.cursor = "grabbing";
        active = true;
        events.drag(...place(e), true);
      },
      { signal },
    );
    element.addEventListener(
      "pointermove",
      (e) => element.hasPointerCapture(e.pointerId) && events.drag(...place(e), false),
      { signal },
    );
    for (const end of ["lostpointercapture", "keyup"] as const) {
      element.addEventListener(
        end,
        () => {
          element.style.cursor = "grab";
          if (active) events.done();
          active = false;
        },
        { signal },
      );
    }
    element.addEventListener(
      "keydown",
      (e) => {
        const steps = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[e.key];
        if (steps === undefined || e.ctrlKey || e.altKey || e.metaKey) return;
        e.preventDefault();
        e.stopPropagation();
        active = true;
        events.nudge(e.shiftKey ? 10 * Math.sign(steps) : steps);
      },
      { signal },
    );
  }

  setColours(fill: string, rim: string, letter: string): void {
    this.knob.style.background = fill;
    this.knob.style.borderColor = rim;
    this.knob.style.color = letter;
  }

  setValue(value: number, low: number, high: number): void {
    this.element.setAttribute("aria-valuenow", value.toFixed(1));
    this.element.setAttribute("aria-valuemin", low.toFixed(1));
    this.element.setAttribute("aria-valuemax", high.toFixed(1));
    this.element.setAttribute("aria-valuetext", `${value.toFixed(1)} mm`);
  }

  moveTo(at: { x: number; y: number } | null): void {
    this.element.style.display = at ? "block" : "none";
    if (at) this.element.style.transform = `translate(${(at.x - 16).toFixed(1)}px, ${(at.y - 16).toFixed(1)}px)`;
  }

  dispose(): void {
    this.leave.abort();
    this.element.remove();
  }
}

/// Where a point of the tray is in the view, in CSS pixels; null behind the viewer.
export function onScreen(
  orbit: Orbit,
  lens: Lens,
  p: Size,
  width: number,
  height: number,
): { x: number; y: number } | null {
  const { x, y, depth } = project(orbit, lens, p);
  return depth > 0 ? { x: ((x + 1) / 2) * width, y: ((1 - y) / 2) * height } : null;
}
