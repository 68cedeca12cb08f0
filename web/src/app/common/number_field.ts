/// A field for a number, with its unit. What is typed counts when the field is left or Enter is pressed; arrow keys and,
/// while it has the focus, the wheel change it by a step. Tells of changes by a "value" event.

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { parseNumber, short } from "../words/numbers";
import { Piece } from "./piece";

export type ValueEvent = CustomEvent<number | null>;

@customElement("sp-number")
export class NumberField extends Piece {
  @property() label = "";
  @property() unit = "";
  @property({ attribute: false }) value: number | null = null;
  @property({ type: Number }) least = Number.NEGATIVE_INFINITY;
  @property({ type: Number }) most = Number.POSITIVE_INFINITY;
  /// The least value itself is too small.
  @property({ type: Boolean }) above = false;
  @property({ type: Number }) step = 1;
  @property({ type: Number }) digits = 2;
  /// Digits behind the point that are always shown.
  @property({ type: Number }) places = 0;
  /// Nothing typed is a value: null.
  @property({ type: Boolean }) optional = false;
  @property() placeholder = "";
  @property({ type: Boolean }) mixed = false;
  @property({ type: Boolean }) disabled = false;
  @property() classes = "n";
  @property({ type: Number }) tab = 0;
  @state() private problem = "";
  @query("input") private readonly input!: HTMLInputElement;
  private typing = false;

  override focus(): void {
    this.input?.focus();
    this.input?.select();
  }

  private shown(): string {
    if (this.mixed || this.value === null) return "";
    return this.places > 0 && Number.isInteger(this.value * 10 ** this.places)
      ? this.value.toFixed(this.places)
      : short(this.value, Math.max(this.digits, this.places));
  }

  protected override updated(): void {
    const text = this.shown();
    if (!this.typing && this.input.value !== text) this.input.value = text;
  }

  override render() {
    return html`<span class="in ${this.classes} ${this.problem ? "wrong" : ""}">
        <input
          type="text"
          inputmode="decimal"
          autocomplete="off"
          spellcheck="false"
          tabindex=${this.tab}
          aria-label=${this.label}
          aria-invalid=${this.problem !== ""}
          placeholder=${this.mixed ? "–" : this.placeholder}
          ?disabled=${this.disabled}
          @input=${this.typed}
          @change=${this.commit}
          @focus=${() => this.input.select()}
          @blur=${this.commit}
          @keydown=${this.key}
          @wheel=${{ handleEvent: (event: WheelEvent) => this.wheel(event), passive: false }}
        />${this.unit ? html`<span class="u">${this.unit}</span>` : nothing}</span
      >${this.problem ? html`<span class="range" role="alert">${this.problem}</span>` : nothing}`;
  }

  private typed(): void {
    this.typing = true;
    this.problem = "";
  }

  private commit(): void {
    if (!this.typing) return;
    const text = this.input.value.trim();
    if (text === "" && (this.optional || this.mixed)) {
      this.done(this.mixed ? undefined : null);
      return;
    }
    const value = parseNumber(text);
    const wrong = value === null || value > this.most || (this.above ? value <= this.least : value < this.least);
    if (wrong) {
      this.problem = this.range();
      return;
    }
    this.done(Number(value.toFixed(this.digits)));
  }

  /// Undefined: as it was.
  private done(value: number | null | undefined): void {
    this.typing = false;
    this.problem = "";
    const before = this.value;
    if (value !== undefined && (value !== before || this.mixed)) {
      this.dispatchEvent(new CustomEvent("value", { detail: value, bubbles: true }));
    }
    this.requestUpdate();
    this.input.value = value === undefined || value === before ? this.shown() : this.input.value;
  }

  private range(): string {
    const { least, most } = this;
    const from = this.above ? `more than ${short(least)}` : `${short(least)} or more`;
    if (Number.isFinite(least) && Number.isFinite(most)) return `${short(least)} to ${short(most)}`;
    if (Number.isFinite(least)) return from;
    return Number.isFinite(most) ? `${short(most)} or less` : "A number";
  }

  private key(event: KeyboardEvent): void {
    if (event.key === "Enter") this.commit();
    else if (event.key === "Escape" && this.typing) {
      event.stopPropagation();
      this.typing = false;
      this.problem = "";
      this.input.value = this.shown();
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      event.stopPropagation();
      this.stepBy(event.key === "ArrowUp" ? 1 : -1, event.shiftKey);
    }
  }

  private wheel(event: WheelEvent): void {
    if (document.activeElement !== this.input || this.disabled) return;
    event.preventDefault();
    this.stepBy(event.deltaY < 0 ? 1 : -1, event.shiftKey);
  }

  stepBy(direction: number, ten: boolean): void {
    const typed = this.typing ? parseNumber(this.input.value) : this.value;
    const from = typed ?? (Number.isFinite(this.least) ? this.least : 0);
    const next = from + direction * this.step * (ten ? 10 : 1);
    const least = this.above ? this.least + this.step : this.least;
    this.typing = true;
    this.input.value = short(Math.min(this.most, Math.max(least, next)), this.digits);
    this.commit();
  }
}
