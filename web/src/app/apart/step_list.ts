/// The steps in order, groups with their copies, and what stays. Thousands of them: only the rows in sight are drawn. The
/// step that runs stays in sight while it plays.

import { html, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { Piece } from "../common/piece";
import { styles } from "../common/styles";
import { playerOf } from "../state/apart_player";
import { type Row, rowOfStep, rowsOf } from "../state/apart_rows";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { count } from "../words/numbers";
import { type Apart, selectedIn } from "./apart";
import { stepRow } from "./step_row";

/// As the sheet has it; on narrow screens rows are higher, to be touched.
const rowHeights = { usual: 36, narrow: 44 } as const;
const narrow = matchMedia("(max-width: 1023px)");
/// Rows above and below those in sight.
const spare = 10;
/// The step that runs is kept away from the ends of the list by this share of its height.
const margin = 0.2;

@customElement("sp-steps")
export class StepList extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) apart!: Apart;
  @query(".scroll") private readonly scroller!: HTMLElement;
  private rows: readonly Row[] = [];
  private places: readonly number[] = [];
  private rowsOf: unknown = null;
  private top = 0;
  private height = 900;
  private followed = -1;
  private readonly sizes = new ResizeObserver(() => {
    // In a drawer that opens, it is looked for anew.
    if (this.height === 0) this.followed = -1;
    this.height = this.scroller.clientHeight;
    this.requestUpdate();
  });

  protected override stores() {
    const { session } = this;
    return [session.build, session.meshes.state, playerOf(session).state, app];
  }

  protected override firstUpdated(): void {
    this.sizes.observe(this.scroller);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sizes.disconnect();
  }

  protected override willUpdate(): void {
    super.willUpdate();
    if (this.apart.plan === this.rowsOf) return;
    this.rowsOf = this.apart.plan;
    this.rows = rowsOf(this.apart.plan);
    this.places = rowOfStep(this.rows);
  }

  protected override updated(_changed: PropertyValues): void {
    const { step } = playerOf(this.session).state.value;
    if (step === this.followed) return;
    this.followed = step;
    const { clientHeight, scrollTop } = this.scroller;
    if (clientHeight === 0) return;
    const y = (this.places[step] ?? this.rows.length) * this.rowHeight;
    const low = scrollTop + margin * clientHeight;
    const high = scrollTop + (1 - margin) * clientHeight - this.rowHeight;
    if (y >= low && y <= high) return;
    this.scroller.scrollTop = y - 0.4 * clientHeight;
    // At once: the scroll event would come a frame later.
    this.top = this.scroller.scrollTop;
    this.requestUpdate();
  }

  private get rowHeight(): number {
    return narrow.matches ? rowHeights.narrow : rowHeights.usual;
  }

  override render() {
    const { rows, rowHeight, apart } = this;
    const first = Math.max(0, Math.floor(this.top / rowHeight) - spare);
    const last = Math.min(rows.length, Math.ceil((this.top + this.height) / rowHeight) + spare);
    const { step } = playerOf(this.session).state.value;
    const selected = selectedIn(this.session, apart.tray)?.index ?? null;
    return html`<div class="head">
        <h2 class="grow">Steps</h2>
        <span class="count">${count(apart.plan.steps.length)} · moves in mm</span>
      </div>
      <div
        class="scroll"
        @scroll=${() => {
          this.top = this.scroller.scrollTop;
          this.requestUpdate();
        }}
      >
        <div role="list" aria-label="Steps">
          ${this.space(first * rowHeight)}
          ${repeat(
            rows.slice(first, last),
            (_, i) => first + i,
            (row): TemplateResult => stepRow({ session: this.session, apart, row, step, selected }),
          )}
          ${this.space((rows.length - last) * rowHeight)}
        </div>
      </div>`;
  }

  private space(height: number): TemplateResult {
    return html`<div role="presentation" ${styles({ height: `${height}px` })}></div>`;
  }
}
