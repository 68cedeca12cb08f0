/// A whole number with a button for one less and one for one more.

import { html, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { icon } from "./icons";
import type { NumberField } from "./number_field";
import "./number_field";
import { Piece } from "./piece";

@customElement("sp-stepper")
export class Stepper extends Piece {
  @property() label = "";
  @property({ attribute: false }) value: number | null = null;
  @property({ type: Number }) least = 1;
  @property({ type: Number }) most = 1_000_000;
  @property({ type: Boolean }) mixed = false;
  @property({ type: Boolean }) disabled = false;
  /// Without buttons, until the row is looked at.
  @property({ type: Boolean }) bare = false;
  @property({ type: Number }) tab = 0;
  @query("sp-number") private readonly field!: NumberField;

  override focus(): void {
    this.field?.focus();
  }

  override render() {
    const button = (name: "minus" | "add", text: string, by: number, end: boolean) =>
      this.bare
        ? nothing
        : html`<button
            type="button"
            class="more-less"
            tabindex="-1"
            aria-label="${text} ${this.label}"
            ?disabled=${this.disabled || end}
            @click=${() => this.field.stepBy(by, false)}
          >
            ${icon(name)}
          </button>`;
    return html`<span class="step ${this.bare ? "bare" : ""}">
      ${button("minus", "One less:", -1, this.value !== null && this.value <= this.least)}
      <sp-number
        .label=${this.label}
        .value=${this.value}
        .least=${this.least}
        .most=${this.most}
        .digits=${0}
        .tab=${this.tab}
        ?mixed=${this.mixed}
        ?disabled=${this.disabled}
        classes="in-step"
      ></sp-number>
      ${button("add", "One more:", 1, false)}
    </span>`;
  }
}
