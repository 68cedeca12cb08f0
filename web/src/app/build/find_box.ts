/// Finds a part or a copy by its name: "fan-blower", "fan-blower 4". Arrow keys choose, Enter selects and frames.

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { partColour } from "../../view/palette";
import type { CopyKey } from "../../view/view";
import { picture } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { copies } from "../words/numbers";
import type { BuildPart } from "./build_parts";

interface Hit {
  readonly part: BuildPart;
  readonly copies: readonly CopyKey[];
  readonly text: string;
}

const most = 10;

@customElement("sp-find")
export class FindBox extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];
  @property({ type: Number }) tray = 1;
  @state() private at = 0;
  @query("input") private readonly input!: HTMLInputElement;

  protected override stores() {
    return [this.session.build, this.session.meshes.state];
  }

  protected override firstUpdated(): void {
    this.input.focus();
  }

  private standing(): ReadonlyMap<number, CopyKey[]> {
    const { live, state } = this.session.run;
    const packed = state.value.packing?.trays[this.tray - 1]?.placements;
    const all: Iterable<CopyKey> = packed ?? live.trays.get(this.tray)?.copies.values() ?? [];
    const byPart = new Map<number, CopyKey[]>();
    for (const { part, copy } of all) byPart.set(part, [...(byPart.get(part) ?? []), { part, copy }]);
    return byPart;
  }

  /// Parts whose name has what was typed, and with a number behind it their copy of that number.
  private hits(): Hit[] {
    const typed = (this.session.build.value.find ?? "").trim().toLowerCase();
    const number = /^(.*\S)\s+(\d+)$/.exec(typed);
    const standing = this.standing();
    const hits: Hit[] = [];
    for (const part of this.parts) {
      const own = standing.get(part.index) ?? [];
      if (own.length === 0) continue;
      const name = part.name.toLowerCase();
      if (number?.[1] && name.includes(number[1])) {
        const copy = own.find((key) => key.copy === Number(number[2]) - 1);
        if (copy) hits.unshift({ part, copies: [copy], text: `${part.name} ${copy.copy + 1}` });
      }
      if (name.includes(typed)) hits.push({ part, copies: own, text: part.name });
    }
    return hits.slice(0, most);
  }

  override render() {
    const hits = this.hits();
    const { meshes, build } = this.session;
    return html`<div class="hud find-box card" role="search">
      <span class="in wide">
        ${icon("find")}
        <input
          type="search"
          role="combobox"
          aria-expanded="true"
          aria-controls="find-hits"
          aria-activedescendant=${hits.length > 0 ? `hit-${this.at}` : nothing}
          aria-label="Find a copy or part"
          placeholder="fan-blower 4"
          .value=${build.value.find ?? ""}
          @input=${(event: Event) => {
            this.at = 0;
            build.set({ find: (event.target as HTMLInputElement).value });
          }}
          @keydown=${(event: KeyboardEvent) => this.key(event, hits)}
        />
      </span>
      <div id="find-hits" role="listbox" aria-label="Found">
        ${hits.map(
          (hit, i) =>
            html`<div
              id="hit-${i}"
              class="li ${i === this.at ? "sel" : ""}"
              role="option"
              aria-selected=${i === this.at}
              @click=${() => this.take(hit)}
            >
              ${picture(hit.part.mesh ? meshes.picture(hit.part.mesh, partColour(hit.part.index), app.value.theme) : null)}
              <span class="cut">${hit.text}</span>
              <span class="count">${hit.copies.length > 1 ? copies(hit.copies.length) : ""}</span>
            </div>`,
        )}
        ${hits.length === 0 ? html`<p class="small dim none">Nothing of that name stands in this tray.</p>` : nothing}
      </div>
    </div>`;
  }

  private key(event: KeyboardEvent, hits: readonly Hit[]): void {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      const by = event.key === "ArrowDown" ? 1 : hits.length - 1;
      this.at = hits.length > 0 ? (this.at + by) % hits.length : 0;
    } else if (event.key === "Enter") {
      const hit = hits[this.at];
      if (hit) this.take(hit);
    } else if (event.key === "Escape") {
      event.stopPropagation();
      this.session.build.set({ find: null });
    }
  }

  private take(hit: Hit): void {
    this.session.build.set({ selected: hit.copies, find: null });
    this.dispatchEvent(new CustomEvent("found", { bubbles: true }));
  }
}
