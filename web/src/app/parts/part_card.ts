/// Below the preview: how the part may stand. Where several are chosen, and on narrow screens, the fields that the list
/// has no room for as well; "–" stands where the chosen parts differ.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { segments, select } from "../common/bits";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import { Piece } from "../common/piece";
import type { AxisName, DraftPart, Stands } from "../state/draft";
import { changeParts, type PartChange } from "../state/draft_edit";
import type { Session } from "../state/session";
import { gapOf } from "../state/tray_size";
import {
  axisNames,
  axisText,
  priorities,
  rotationsText,
  standsChoices,
  standsHelp,
  standsOfKind,
} from "../words/stands";

@customElement("sp-part-card")
export class PartCard extends Piece {
  @property({ attribute: false }) session!: Session;

  protected override stores() {
    return [this.session.state, this.session.view];
  }

  /// The parts that the card changes: the chosen ones, else the one that is looked at.
  private get parts(): readonly DraftPart[] {
    const { chosen, current } = this.session.view.value;
    return this.session.draft.parts.filter((part) => (chosen.size > 0 ? chosen.has(part.key) : part.key === current));
  }

  private change(change: PartChange, tag = ""): void {
    const keys = new Set(this.parts.map((part) => part.key));
    this.session.edit((draft) => changeParts(draft, keys, change), tag && `${tag} ${keys.size}`);
  }

  override render() {
    const { parts } = this;
    const [first] = parts;
    if (!first) return nothing;
    const several = parts.length > 1;
    const kind = parts.every((part) => part.stands.kind === first.stands.kind) ? first.stands.kind : null;
    const rotations = rotationsText(this.session.draft.options.rotations);
    return html`<div class="hud bl wide">
      <div class="card part-card">
        <div class="row between">
          <span class="small dim">${several ? `${parts.length} parts may stand` : "May stand"}</span>
          <span class="small faint cut">${kind === null ? "" : standsHelp(first.stands, rotations)}</span>
        </div>
        ${segments(
          "May stand",
          standsChoices,
          kind,
          (next) => this.change({ stands: standsOfKind(next, several ? { kind: "any" } : first.stands) }),
          "fill s icons",
        )}
        ${first.stands.kind === "axes" && kind === "axes" ? this.axes(first.stands) : nothing}
        <div class="fields ${several ? "" : "only-s"}">${this.fields(parts, first, several)}</div>
      </div>
    </div>`;
  }

  private axes(stands: Extract<Stands, { kind: "axes" }>): TemplateResult {
    const toggle = (axis: AxisName) => {
      const on = stands.axes.includes(axis);
      const axes = on ? stands.axes.filter((other) => other !== axis) : [...stands.axes, axis];
      if (axes.length > 0) this.change({ stands: { ...stands, axes } });
    };
    return html`<div class="row axes">
      <span class="small dim">Up</span>
      <div class="seg fill s" role="group" aria-label="Directions of the part that may point up">
        ${axisNames.map(
          (axis) =>
            html`<button type="button" aria-pressed=${stands.axes.includes(axis)} @click=${() => toggle(axis)}>
              ${axisText(axis)}
            </button>`,
        )}
      </div>
      ${select(
        "Turned about the vertical in steps of",
        [
          { value: "", text: "usual turns" },
          { value: "90", text: "90° turns" },
          { value: "45", text: "45° turns" },
          { value: "15", text: "15° turns" },
          { value: "360", text: "no turns" },
        ],
        stands.yaw === null ? "" : String(stands.yaw),
        (value) => this.change({ stands: { ...stands, yaw: value === "" ? null : Number(value) } }),
        "s",
      )}
    </div>`;
  }

  private fields(parts: readonly DraftPart[], first: DraftPart, several: boolean): TemplateResult {
    const same = <T>(value: (part: DraftPart) => T) => parts.every((part) => value(part) === value(first));
    const usual = gapOf(this.session.draft, this.session.info).toFixed(1);
    const priority = same((part) => part.priority) ? String(first.priority) : null;
    return html`${
      several
        ? html`<label class="field"
              ><span class="dim">Copies</span>
              <sp-number
                label="Copies of each"
                .value=${first.count}
                ?mixed=${!same((part) => part.count)}
                .least=${1}
                .digits=${0}
                @value=${(event: ValueEvent) => this.change({ count: event.detail ?? 1 }, "count")}
              ></sp-number>
            </label>
            <label class="field"
              ><span class="dim">Scale</span>
              <sp-number
                label="Scale"
                unit="%"
                .value=${first.scale * 100}
                ?mixed=${!same((part) => part.scale)}
                .least=${0}
                above
                .digits=${4}
                @value=${(event: ValueEvent) => this.change({ scale: (event.detail ?? 100) / 100 }, "scale")}
              ></sp-number>
            </label>`
        : nothing
    }
      <label class="field"
        ><span class="dim">Gap</span>
        <sp-number
          label="Gap"
          unit="mm"
          optional
          placeholder=${usual}
          .value=${first.gap}
          ?mixed=${!same((part) => part.gap)}
          .least=${0}
          .step=${0.5}
          .places=${1}
          @value=${(event: ValueEvent) => this.change({ gap: event.detail }, "gap")}
        ></sp-number>
      </label>
      <div class="field">
        <span class="dim">Priority</span>
        ${select("Priority", priorities, priority, (value) => this.change({ priority: Number(value) }), "n")}
      </div>
      ${
        several
          ? html`<label class="field"
              ><span class="dim">Due</span>
              <span class="in n date"
                ><input
                  type="date"
                  aria-label="Due date"
                  .value=${same((part) => part.due) ? (first.due ?? "") : ""}
                  @change=${(event: Event) => this.change({ due: (event.target as HTMLInputElement).value || null })}
              /></span>
            </label>`
          : nothing
      }`;
  }
}
