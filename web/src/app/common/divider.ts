/// The line between a side panel and the middle: dragged, or moved by arrow keys; a double click puts it back. The width
/// is a custom property of the parent, kept for the next visit.

import { customElement, property } from "lit/decorators.js";
import { keep, kept } from "../state/kept";
import { Piece } from "./piece";

@customElement("sp-divider")
export class Divider extends Piece {
  /// The custom property, "--left".
  @property() property = "";
  /// Which side of the line the panel is on.
  @property() side: "left" | "right" = "left";
  @property() label = "";
  @property({ type: Number }) least = 200;
  @property({ type: Number }) most = 900;

  override connectedCallback(): void {
    super.connectedCallback();
    this.tabIndex = 0;
    this.setAttribute("role", "separator");
    this.setAttribute("aria-orientation", "vertical");
    this.addEventListener("pointerdown", this.grab);
    this.addEventListener("dblclick", () => this.put(null));
    this.addEventListener("keydown", this.key);
  }

  protected override updated(): void {
    this.setAttribute("aria-label", this.label);
    const width = kept<number | null>(`width${this.property}`, null);
    if (width !== null) this.show(width);
    const { panel } = this;
    if (panel) this.setAttribute("aria-valuenow", panel.getBoundingClientRect().width.toFixed(0));
    this.setAttribute("aria-valuemin", String(this.least));
    this.setAttribute("aria-valuemax", String(this.most));
  }

  private get panel(): HTMLElement | null {
    const sibling = this.side === "left" ? this.previousElementSibling : this.nextElementSibling;
    return sibling as HTMLElement | null;
  }

  private readonly grab = (event: PointerEvent) => {
    const panel = this.panel;
    if (!panel) return;
    event.preventDefault();
    this.setPointerCapture(event.pointerId);
    const start = panel.getBoundingClientRect().width;
    const from = event.clientX;
    const move = (moved: PointerEvent) => {
      const by = moved.clientX - from;
      this.show(start + (this.side === "left" ? by : -by));
    };
    const end = () => {
      this.removeEventListener("pointermove", move);
      if (panel.getBoundingClientRect().width !== start) this.put(panel.getBoundingClientRect().width);
    };
    this.addEventListener("pointermove", move);
    this.addEventListener("lostpointercapture", end, { once: true });
  };

  private readonly key = (event: KeyboardEvent) => {
    const by = event.key === "ArrowLeft" ? -16 : event.key === "ArrowRight" ? 16 : 0;
    if (by === 0 || !this.panel) return;
    event.preventDefault();
    event.stopPropagation();
    this.put(this.panel.getBoundingClientRect().width + (this.side === "left" ? by : -by));
  };

  private show(width: number): void {
    const held = Math.max(this.least, Math.min(this.most, width));
    this.parentElement?.style.setProperty(this.property, `${held}px`);
    this.setAttribute("aria-valuenow", held.toFixed(0));
  }

  private put(width: number | null): void {
    keep(`width${this.property}`, width);
    if (width === null) this.parentElement?.style.removeProperty(this.property);
    else this.show(width);
  }
}
