/// A row of the parts list. The row that is looked at shows its fields; of the others only the copies are a field.

import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../../view/palette";
import { checkBox, picture } from "../common/bits";
import { icon } from "../common/icons";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import "../common/stepper";
import { app } from "../state/app_state";
import type { DraftPart } from "../state/draft";
import { changeParts, type PartChange } from "../state/draft_edit";
import { together } from "../state/parts_view";
import type { Session } from "../state/session";
import { gapOf } from "../state/tray_size";
import { percent, size } from "../words/numbers";
import { priorities, priorityText, standsIcon, standsText } from "../words/stands";
import { due } from "../words/times";
import type { Cell, Column } from "./grid_keys";
import { columns } from "./grid_keys";
import { remarkRow } from "./remark_row";
import { nameOf, type Row, sizeOf } from "./rows";
import { standsMenu } from "./stands_menu";

export function partRow(session: Session, row: Row, place: number, cell: Cell): TemplateResult {
  const { part, mesh } = row;
  const { current, chosen } = session.view.value;
  const isCurrent = current === part.key;
  const isChosen = chosen.has(part.key);
  const sides = sizeOf(row, session);
  const name = nameOf(part, mesh);
  const tab = (column: Column) => (cell.row === place && columns[cell.column] === column ? 0 : -1);
  const change = (change: PartChange, tag = "") =>
    session.edit((draft) => changeParts(draft, together(session.view.value, part.key), change), `${tag} ${part.key}`);
  const fields = new Fields(session, part, name, change);
  const colour = partColour(row.index);
  const remarks = row.remarks;
  return html`<div
    class="pr ${isCurrent ? "sel" : ""} ${isChosen ? "chosen" : ""} ${remarks.length > 0 ? "has" : ""}"
    role="row"
    aria-rowindex=${place + 2}
    aria-selected=${isChosen}
    data-row=${place}
    @pointerdown=${() => session.view.set({ current: part.key })}
  >
    <span role="gridcell" class="c-check" data-column="check" tabindex=${tab("check")}>
      ${checkBox(`Choose ${name}`, isChosen, (on, event) => choose(session, part.key, on, event.shiftKey), -1)}
    </span>
    ${
      mesh
        ? picture(session.meshes.picture(mesh, colour, app.value.theme))
        : html`<span class="th blank ${remarks.length > 0 ? "" : "reading"}"></span>`
    }
    <span role="gridcell" class="nm" data-column="name" tabindex=${tab("name")}>
      <b class="cut" title=${name}>${name}</b>
      <span class="cut">${sides ? size(sides) : mesh === null && remarks.length > 0 ? part.file : "is read …"}</span>
    </span>
    <span role="gridcell" class="num" data-column="count" tabindex=${tab("count")}>${fields.count(isCurrent)}</span>
    <span role="gridcell" class="num" data-column="scale" tabindex=${tab("scale")}>${fields.scale(isCurrent)}</span>
    <span role="gridcell" data-column="stands" tabindex=${tab("stands")}>${fields.stands(isCurrent)}</span>
    <span role="gridcell" class="num hide-s" data-column="gap" tabindex=${tab("gap")}>${fields.gap(isCurrent)}</span>
    <span role="gridcell" class="hide-s" data-column="priority" tabindex=${tab("priority")}
      >${fields.priority(isCurrent)}</span
    >
    <span role="gridcell" class="num" data-column="due" tabindex=${tab("due")}>${fields.due(isCurrent)}</span>
    ${remarks.map((remark) => remarkRow(session, row, remark))}
  </div>`;
}

/// With Shift: all from the row that was looked at last.
function choose(session: Session, key: string, on: boolean, range: boolean): void {
  const { chosen, current } = session.view.value;
  const next = new Set(chosen);
  const keys = session.draft.parts.map((part) => part.key);
  const from = range && current !== null ? keys.indexOf(current) : -1;
  const to = keys.indexOf(key);
  const span = from < 0 ? [key] : keys.slice(Math.min(from, to), Math.max(from, to) + 1);
  for (const own of span) {
    if (on) next.add(own);
    else next.delete(own);
  }
  session.view.set({ chosen: next });
}

/// The fields of a row; text where the row is not looked at.
class Fields {
  constructor(
    private readonly session: Session,
    private readonly part: DraftPart,
    private readonly name: string,
    private readonly change: (change: PartChange, tag?: string) => void,
  ) {}

  count(current: boolean): TemplateResult {
    return html`<sp-stepper
      label=${`copies of ${this.name}`}
      .value=${this.part.count}
      .tab=${-1}
      ?bare=${!current}
      @value=${(event: ValueEvent) => this.change({ count: event.detail ?? 1 }, "count")}
    ></sp-stepper>`;
  }

  scale(current: boolean): TemplateResult {
    if (!current)
      return html`${percent(this.part.scale, this.part.scale * 100 === Math.round(this.part.scale * 100) ? 0 : 1)}`;
    return html`<sp-number
      label=${`Scale of ${this.name}`}
      unit="%"
      classes="s cell"
      .value=${Number((this.part.scale * 100).toFixed(4))}
      .least=${0}
      .above=${true}
      .most=${1e11}
      .digits=${4}
      .tab=${-1}
      @value=${(event: ValueEvent) => this.change({ scale: (event.detail ?? 100) / 100 }, "scale")}
    ></sp-number>`;
  }

  stands(current: boolean): TemplateResult {
    const { stands } = this.part;
    if (!current) return html`<span class="ori">${icon(standsIcon(stands))}${standsText(stands)}</span>`;
    return standsMenu(`${this.name} may stand`, stands, (next) => this.change({ stands: next }));
  }

  gap(current: boolean): TemplateResult {
    const usual = gapOf(this.session.draft, this.session.info).toFixed(1);
    const own = this.part.gap;
    if (!current)
      return html`<span class=${own === null ? "faint" : ""}>${own === null ? usual : own.toFixed(1)}</span>`;
    return html`<sp-number
      label=${`Gap of ${this.name}, mm`}
      classes="s cell"
      placeholder=${usual}
      .value=${own}
      .least=${0}
      .places=${1}
      .step=${0.5}
      .tab=${-1}
      optional
      @value=${(event: ValueEvent) => this.change({ gap: event.detail }, "gap")}
    ></sp-number>`;
  }

  priority(current: boolean): TemplateResult {
    const { priority } = this.part;
    const text = priorityText(priority);
    if (!current) return html`<span class=${priority > 0 ? "b" : priority === 0 ? "faint" : ""}>${text}</span>`;
    const own = priorities.some((choice) => Number(choice.value) === priority)
      ? []
      : [{ value: String(priority), text }];
    return html`<select
      class="plain"
      tabindex="-1"
      aria-label=${`Priority of ${this.name}`}
      @change=${(event: Event) => this.change({ priority: Number((event.target as HTMLSelectElement).value) })}
    >
      ${[...priorities, ...own].map(
        (choice) =>
          html`<option value=${choice.value} .selected=${Number(choice.value) === priority}>${choice.text}</option>`,
      )}
    </select>`;
  }

  due(current: boolean): TemplateResult | typeof nothing {
    const date = this.part.due;
    if (!current) return date === null ? nothing : html`${due(date, new Date())}`;
    return html`<label class="due ${date === null ? "faint" : ""}">
      <span aria-hidden="true">${date === null ? "None" : due(date, new Date())}</span>
      <input
        type="date"
        tabindex="-1"
        aria-label=${`Due date of ${this.name}`}
        .value=${date ?? ""}
        @click=${openPicker}
        @change=${(event: Event) => this.change({ due: (event.target as HTMLInputElement).value || null })}
      />
    </label>`;
  }
}

function openPicker(event: Event): void {
  try {
    (event.target as HTMLInputElement).showPicker();
  } catch {
    // The date can be typed all the same.
  }
}
