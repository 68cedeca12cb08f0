/// The filled area of each layer, standing upright beside the tray, and where the section cuts: dragged, moved by keys,
/// or put by a click. The pointer shows height and share.

import { html, nothing, svg, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { Piece } from "../common/piece";
import { styles } from "../common/styles";
import { fullest, type Layers, layerAt, plotEnd } from "../state/layers";
import type { Session } from "../state/session";
import { percent } from "../words/numbers";
import { movedSection } from "./sections";

@customElement("sp-layers")
export class LayerStrip extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) layers: Layers | null = null;
  /// mm, of the whole plot.
  @property({ type: Number }) height = 0;
  /// Of the tray, filled so far.
  @property({ type: Number }) average = 0;
  @property({ type: Boolean }) live = false;
  @state() private hover: number | null = null;
  private dragging = false;

  protected override stores() {
    return [this.session.build];
  }

  private get cut(): number | null {
    const { section } = this.session.build.value;
    return section?.axis === "z" ? section.at : null;
  }

  override render() {
    const end = plotEnd(this.layers);
    return html`<aside class="strip" aria-label="Filled area of each layer">
      <header><b>Layers</b><span class="dim">filled area</span></header>
      ${
        this.height > 0
          ? html`<div
              class="plot ${this.live ? "" : "cuts"}"
              @pointerdown=${this.grab}
              @pointermove=${this.move}
              @pointerup=${this.drop}
              @pointercancel=${this.drop}
              @pointerleave=${() => {
                this.hover = null;
              }}
            >
              ${this.drawing(end)} ${this.marks()} ${this.cutLine()} ${this.hoverLine()}
            </div>`
          : html`<div class="plot"></div>`
      }
      <footer>
        <div class="row between faint scale">
          <span>0</span><span>${Math.round(end * 50)}</span><span>${percent(end, 0)}</span>
        </div>
        ${this.words()}
      </footer>
    </aside>`;
  }

  private words(): TemplateResult {
    if (this.live || !this.layers) return html`<b>${percent(this.average)}</b> on average,<br />grows as copies land`;
    const { cut } = this;
    if (cut !== null) return html`<b>${percent(layerAt(this.layers, cut))}</b> at the cut<br />Drag to move it`;
    const most = fullest(this.layers);
    return html`<b>${percent(most.share, 0)}</b> at ${most.z.toFixed(0)} mm,<br />the fullest layer`;
  }

  private y(z: number): number {
    return (1 - z / this.height) * 1000;
  }

  private drawing(end: number): TemplateResult {
    const { layers, cut } = this;
    const x = (share: number) => ((share / end) * 100).toFixed(2);
    const points = layers ? outline(layers, x, (z) => this.y(z).toFixed(1)) : "";
    const below = cut === null ? 0 : this.y(cut);
    return html`<svg viewBox="0 0 100 1000" preserveAspectRatio="none" aria-hidden="true">
      ${[1, 2, 3].map((i) => svg`<path class="grid" d="M${i * 25} 0V1000" />`)}
      ${
        points === ""
          ? nothing
          : cut === null
            ? svg`<polygon class="area" points=${points} />`
            : svg`<polygon class="area past" points=${points} />
                <clipPath id="below-cut"><rect x="0" y=${below} width="100" height=${1000 - below} /></clipPath>
                <polygon class="area" points=${points} clip-path="url(#below-cut)" />`
      }
    </svg>`;
  }

  private marks(): TemplateResult[] {
    const step = [10, 20, 50, 100, 200, 500].find((own) => this.height / own <= 5) ?? 1000;
    const marks: TemplateResult[] = [];
    for (let z = step; z < this.height; z += step) {
      marks.push(html`<span class="mark-z" ${styles({ bottom: `${(z / this.height) * 100}%` })}>${z}</span>`);
    }
    return marks;
  }

  private cutLine(): TemplateResult | typeof nothing {
    const { cut } = this;
    if (cut === null || this.live) return nothing;
    return html`<span
      class="cut-line"
      role="slider"
      tabindex="0"
      aria-label="Height of the section, mm"
      aria-orientation="vertical"
      aria-valuemin="0"
      aria-valuemax=${this.height}
      aria-valuenow=${cut}
      ${styles({ bottom: `${(cut / this.height) * 100}%` })}
      @keydown=${this.key}
      ><span>${cut.toFixed(1)}</span></span
    >`;
  }

  private hoverLine(): TemplateResult | typeof nothing {
    const { hover, layers } = this;
    if (hover === null || !layers || this.dragging) return nothing;
    const share = layerAt(layers, hover);
    return html`<span class="hover-line" ${styles({ bottom: `${(hover / this.height) * 100}%` })}
      ><span>${hover.toFixed(0)} mm · ${percent(share)}</span></span
    >`;
  }

  private heightAt(event: PointerEvent): number {
    const plot = event.currentTarget as HTMLElement;
    const { top, height } = plot.getBoundingClientRect();
    const share = Math.max(0, Math.min(1, 1 - (event.clientY - top) / height));
    return Math.round(share * this.height * 10) / 10;
  }

  private cutAt(at: number): void {
    const { build } = this.session;
    const { section } = build.value;
    build.set({ section: { axis: "z", at, flipped: section?.axis === "z" ? section.flipped : false } });
  }

  private grab(event: PointerEvent): void {
    if (this.live) return;
    event.preventDefault();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.dragging = true;
    this.cutAt(this.heightAt(event));
  }

  private move(event: PointerEvent): void {
    if (this.dragging) this.cutAt(this.heightAt(event));
    else this.hover = this.heightAt(event);
  }

  private drop(): void {
    this.dragging = false;
  }

  private key(event: KeyboardEvent): void {
    const { build } = this.session;
    const { section } = build.value;
    const by = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (!section || by === 0) return;
    event.preventDefault();
    event.stopPropagation();
    build.set({ section: movedSection(this.session, section, event.shiftKey ? by * 10 : by) });
  }
}

/// A step outline: every layer as wide as it is filled.
function outline(layers: Layers, x: (share: number) => string, y: (z: number) => string): string {
  const points = [`0,${y(0)}`];
  layers.share.forEach((share, layer) => {
    points.push(`${x(share)},${y((layer + 0.5) * layers.thickness)}`);
  });
  points.push(`0,${y(layers.share.length * layers.thickness)}`);
  return points.join(" ");
}
