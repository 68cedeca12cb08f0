/// The steps as bars, to scrub in. What was done is in the accent; the playhead moves without the bars being drawn again.

import { html, nothing, type PropertyValues, svg, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { Piece } from "../common/piece";
import { styles } from "../common/styles";
import { barsOf, ticksOf } from "../state/apart_bars";
import type { Player } from "../state/apart_player";
import { groupSpans } from "../state/apart_rows";
import { count } from "../words/numbers";
import type { Apart } from "./apart";
import { stepName, stepSentence } from "./sentences";

/// CSS pixels a bar at least, and a number below it.
const leastBar = 3;
const tickRoom = 64;
/// From so many pixels a step on, scrubbing also stops within steps.
const fineBar = 5;

@customElement("sp-timeline")
export class Timeline extends Piece {
  @property({ attribute: false }) player!: Player;
  @property({ attribute: false }) apart!: Apart;
  @state() private width = 0;
  @state() private hovered: number | null = null;
  @query(".track") private readonly track!: HTMLElement;
  private bars: TemplateResult | null = null;
  private barsFor: readonly unknown[] = [];
  private noClock: (() => void) | null = null;
  private resume = false;
  private readonly sizes = new ResizeObserver(() => {
    this.width = this.track.clientWidth;
  });

  protected override stores() {
    return [this.player.state];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.noClock = this.player.clock.subscribe(() => this.placeHead());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.noClock?.();
    this.sizes.disconnect();
  }

  protected override firstUpdated(): void {
    this.sizes.observe(this.track);
  }

  protected override updated(changed: PropertyValues): void {
    this.placeHead();
    // What was pointed at is another step once keys or play have moved on.
    if (!changed.has("hovered") && this.player.state.value.step !== this.hovered) this.hovered = null;
  }

  private get steps(): number {
    return Math.max(1, this.apart.plan.steps.length);
  }

  private placeHead(): void {
    if (!this.track) return;
    const share = Math.min(1, this.player.time / this.steps);
    this.track.style.setProperty("--at", `${(100 * share).toFixed(3)}%`);
  }

  override render() {
    const { apart, player, hovered, steps } = this;
    const { step } = player.state.value;
    const now = Math.min(step, apart.plan.steps.length - 1);
    return html`<div
      class="track"
      role="slider"
      tabindex="0"
      aria-label="Step"
      aria-valuemin="1"
      aria-valuemax=${apart.plan.steps.length}
      aria-valuenow=${now + 1}
      aria-valuetext=${stepSentence(apart, step)}
      @pointerdown=${this.grab}
      @pointermove=${this.hover}
      @pointerleave=${() => {
        this.hovered = null;
      }}
    >
      ${this.drawnBars()}
      <span class="now-bar" ${styles({ left: `${(100 * now) / steps}%`, width: `max(${100 / steps}%, 2px)` })}></span>
      <span class="head-line"></span>
      ${this.ticks()}
      ${hovered === null ? nothing : this.tip(hovered)}
    </div>`;
  }

  /// Twice the same: in the colour of what comes, and in that of what was done, cut off at the playhead.
  private drawnBars(): TemplateResult {
    const { plan } = this.apart;
    if (this.bars && this.barsFor[0] === plan && this.barsFor[1] === this.width) return this.bars;
    this.barsFor = [plan, this.width];
    const bars = barsOf(plan, Math.max(40, this.width / leastBar));
    const gap = 0.3 / bars.length;
    const shape = bars.map(({ from, to, height }) => `M${from + gap / 2} 1V${1 - height}H${to - gap / 2}V1z`).join("");
    const picture = (classes: string) =>
      html`<svg class="bars ${classes}" viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
        ${svg`<path d=${shape} />`}
      </svg>`;
    this.bars = html`${picture("")}${picture("done")}${groupSpans(plan).map(
      ({ first, last }) =>
        html`<span
          class="bracket"
          ${styles({ left: `${(100 * first) / this.steps}%`, width: `max(${(100 * (last + 1 - first)) / this.steps}%, 6px)` })}
        ></span>`,
    )}`;
    return this.bars;
  }

  private ticks(): TemplateResult[] {
    const { steps } = this;
    const { step } = this.player.state.value;
    const now = Math.min(step + 1, steps);
    const room = (tickRoom * steps) / Math.max(1, this.width);
    const place = (number: number) => `${(100 * (number - 0.5)) / steps}%`;
    return [
      ...ticksOf(steps, room)
        .filter((tick) => Math.abs(tick - now) > room * 0.55)
        .map((tick) => html`<span class="tick" ${styles({ left: place(tick) })}>${count(tick)}</span>`),
      html`<b class="tick now" ${styles({ left: place(now) })}>${count(now)}</b>`,
    ];
  }

  private tip(index: number): TemplateResult {
    const own = this.apart.plan.steps[index];
    const share = (index + 0.5) / this.steps;
    return html`<span class="tip" ${styles({ left: `clamp(60px, ${100 * share}%, calc(100% - 60px))` })}
      >${count(index + 1)} ${own ? stepName(this.apart, own) : ""}</span
    >`;
  }

  /// The time under the pointer.
  private timeAt(event: PointerEvent): number {
    const { left, width } = this.track.getBoundingClientRect();
    const share = Math.min(1, Math.max(0, (event.clientX - left) / Math.max(1, width)));
    const time = share * this.steps;
    return width / this.steps >= fineBar ? time : Math.round(time);
  }

  private readonly hover = (event: PointerEvent): void => {
    if (event.pointerType === "touch") return;
    this.hovered = Math.min(this.steps - 1, Math.floor(this.timeAt(event)));
  };

  private readonly grab = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const { track, player } = this;
    this.resume = player.state.value.playing;
    track.setPointerCapture(event.pointerId);
    player.seek(this.timeAt(event));
    const move = (moved: PointerEvent) => player.seek(this.timeAt(moved));
    track.addEventListener("pointermove", move);
    track.addEventListener(
      "lostpointercapture",
      () => {
        track.removeEventListener("pointermove", move);
        if (this.resume) player.play();
      },
      { once: true },
    );
  };
}
