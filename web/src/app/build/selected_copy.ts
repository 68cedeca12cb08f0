/// The copy that is selected: where and how it stands, what is nearest, how it leaves. Of several: what they share.

import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api } from "../../api/client";
import type { Clearance } from "../../api/types";
import { partColour } from "../../view/palette";
import { iconButton, picture } from "../common/bits";
import { icon, spinner } from "../common/icons";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { copyId } from "../state/live_run";
import type { Packing, Placement } from "../state/packing";
import type { Session } from "../state/session";
import { extentOf, standsWords, wayWords } from "../state/turns";
import { copies, counted, mm, ordinal, size, volume } from "../words/numbers";
import type { BuildPart } from "./build_parts";
import { selectedCopies } from "./change_keys";
import { copyButtons } from "./copy_buttons";

/// While somebody clicks from copy to copy nothing is measured.
const after = 200;

@customElement("sp-selected")
export class SelectedCopy extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) packing!: Packing;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];
  @property({ type: Number }) tray = 1;
  @state() private clearance: Clearance | null = null;
  @state() private unknown = false;
  private asked = "";
  private timer = 0;
  private asking: AbortController | null = null;

  protected override stores() {
    const { session } = this;
    return [session.build, session.meshes.state, session.work.state, session.run.state, app];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.timer);
    this.asking?.abort();
  }

  private get placements(): Placement[] {
    const { byId } = this.packing.trays[this.tray - 1] ?? { byId: new Map<string, Placement>() };
    return this.session.build.value.selected.flatMap((copy) => byId.get(copyId(copy)) ?? []);
  }

  protected override updated(_changed: PropertyValues): void {
    const { placements } = this;
    const one = placements.length === 1 ? placements[0] : undefined;
    // What is on its way to the server is measured once it is there.
    const { unchecked } = this.session.work;
    const key = one && !unchecked ? `${this.tray}/${one.index}/${this.session.job.revision}/${copyId(one)}` : "";
    if (key === this.asked) return;
    this.asked = key;
    clearTimeout(this.timer);
    this.asking?.abort();
    this.clearance = null;
    this.unknown = false;
    if (one) this.timer = window.setTimeout(() => void this.measure(one.index), after);
  }

  private async measure(placement: number): Promise<void> {
    const asking = new AbortController();
    this.asking = asking;
    try {
      const clearance = await api.clearance(this.session.id, this.tray, placement, asking.signal);
      if (!asking.signal.aborted) this.clearance = clearance;
    } catch {
      if (!asking.signal.aborted) this.unknown = true;
    }
  }

  override render() {
    const { placements } = this;
    const [first] = placements;
    if (!first) return nothing;
    return html`<section class="sec selected" aria-label="Selected copy">
      ${placements.length === 1 ? this.one(first) : this.several(placements)}
    </section>`;
  }

  private head(part: BuildPart | undefined, title: string, below: string): TemplateResult {
    const { meshes, work } = this.session;
    const own = selectedCopies(this.session);
    const locked = own.length > 0 && own.every((copy) => work.isLocked(copy));
    const shot = part?.mesh ? meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
    return html`<div class="row">
      ${picture(shot, "th large")}
      <div class="grow cut">
        <h2 class="cut row">
          <span class="cut">${title}</span>
          ${locked ? html`<span class="locked" role="img" aria-label="Locked" title="Locked">${icon("lock")}</span>` : nothing}
        </h2>
        <div class="small dim cut">${below}</div>
      </div>
      ${iconButton("close", "Let go (Esc)", () => this.session.build.set({ selected: [] }), "s")}
    </div>`;
  }

  private one(placement: Placement): TemplateResult {
    const part = this.parts.find((own) => own.index === placement.part);
    const name = part?.name ?? "";
    const number = placement.copy + 1;
    return html`${this.head(
      part,
      `${name} ${number}`,
      `copy ${number} of ${part?.count ?? number} · placed ${ordinal(placement.index + 1)}`,
    )}
      <dl class="kv">
        ${this.place(placement, part)}
        <dt>Stands</dt>
        <dd>${standsWords(placement.transform)}</dd>
        ${this.nearest()}
        <dt>Way out</dt>
        <dd>${this.way(placement)}</dd>
      </dl>
      ${copyButtons(this.session)} ${this.steps(placement)}`;
  }

  private place(placement: Placement, part: BuildPart | undefined): TemplateResult | typeof nothing {
    const mesh = part?.mesh;
    if (!mesh) return nothing;
    const box = mesh.box.map((corner) => corner.map((value) => value / mesh.unit));
    const extent = extentOf(placement.transform, box, this.session.meshes.mesh(mesh)?.positions ?? null);
    const at = extent.low.map((value) => Math.abs(value).toFixed(1));
    const sides = extent.high.map((high, axis) => high - (extent.low[axis] ?? 0));
    return html`<dt>Place</dt>
      <dd class="nw">X ${at[0]} &nbsp;Y ${at[1]} &nbsp;Z ${at[2]}</dd>
      <dt>Takes</dt>
      <dd>${size(sides, true)}</dd>`;
  }

  private nearest(): TemplateResult {
    const { clearance, unknown } = this;
    const later = this.session.work.unchecked;
    const wait =
      unknown || later ? html`<span class="faint">${later ? "after the check" : "not measured"}</span>` : spinner;
    const { nearest, wall } = clearance ?? {};
    const name = nearest ? this.parts.find((part) => part.index === nearest.part)?.name : "";
    return html`<dt>Nearest copy</dt>
      <dd>
        ${
          !clearance
            ? wait
            : nearest
              ? html`<button
                    type="button"
                    class="link"
                    @click=${() => this.session.build.set({ selected: [{ part: nearest.part, copy: nearest.copy }] })}
                  >
                    ${name} ${nearest.copy + 1}</button
                  > · ${mm(nearest.distance, 2)}`
              : "none"
        }
      </dd>
      <dt>Nearest wall</dt>
      <dd>${!clearance ? wait : wall ? `${wall.side} · ${mm(wall.distance, 2)}` : "none"}</dd>`;
  }

  private way(placement: Placement): string {
    const tray = this.packing.trays[this.tray - 1];
    if (this.session.work.unchecked) return "after the check";
    if (placement.step === null) return placement.fixed ? "stays where it is" : "not known";
    const group = placement.together > 1 ? `, with ${counted(placement.together - 1, "other")}` : "";
    return `step ${placement.step} of ${tray?.steps ?? 0} · ${wayWords(placement.path)}${group}`;
  }

  /// To the copies of the same part before and after.
  private steps(placement: Placement): TemplateResult | typeof nothing {
    const own = (this.packing.trays[this.tray - 1]?.placements ?? []).filter((other) => other.part === placement.part);
    if (own.length < 2) return nothing;
    const at = own.findIndex((other) => other.copy === placement.copy);
    const to = (by: number) => {
      const next = own[(at + by + own.length) % own.length];
      if (next) this.session.build.set({ selected: [{ part: next.part, copy: next.copy }] });
    };
    return html`<div class="row between steps">
      ${iconButton("left", "The copy before", () => to(-1), "s")}
      <button
        type="button"
        class="link small"
        @click=${() => this.session.build.set({ selected: own.map(({ part, copy }) => ({ part, copy })) })}
      >
        Select all ${copies(own.length)}
      </button>
      ${iconButton("right", "The next copy", () => to(1), "s")}
    </div>`;
  }

  private several(placements: readonly Placement[]): TemplateResult {
    const kinds = new Set(placements.map((placement) => placement.part));
    const [first] = placements;
    const part = kinds.size === 1 ? this.parts.find((own) => own.index === first?.part) : undefined;
    const sum = placements.reduce(
      (all, placement) => all + (this.parts.find((own) => own.index === placement.part)?.volume ?? 0),
      0,
    );
    const stands = new Set(placements.map((placement) => standsWords(placement.transform)));
    const title = part ? part.name : counted(kinds.size, "part");
    return html`${this.head(part, title, `${copies(placements.length)} selected`)}
      <dl class="kv">
        <dt>Volume</dt>
        <dd>${volume(sum)}</dd>
        <dt>Stand</dt>
        <dd>${stands.size === 1 ? [...stands][0] : counted(stands.size, "way")}</dd>
      </dl>
      ${copyButtons(this.session)}
      ${
        part && first
          ? html`<div class="row between steps">
              <button
                type="button"
                class="link small"
                @click=${() => this.session.build.set({ selected: [{ part: first.part, copy: first.copy }] })}
              >
                One after the other
              </button>
            </div>`
          : nothing
      }`;
  }
}
