/// All that can be taken away of a build, as links: the browser downloads them. Held back while copies overlap.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { type ResultKind, resultUrl } from "../../api/client";
import { exportHeld } from "../change/verdict";
import { badge } from "../common/bits";
import { type IconName, icon, spinner } from "../common/icons";
import type { Menu } from "../common/menu";
import "../common/menu";
import { Piece } from "../common/piece";
import { attempt } from "../state/app_state";
import type { Session } from "../state/session";
import { verdictWords } from "../words/jobs";
import { copies } from "../words/numbers";
import { shownPicture } from "./shown_picture";

interface Kind {
  readonly kind: ResultKind;
  readonly icon: IconName;
  readonly text: string;
  readonly what: string;
}

const kinds: readonly Kind[] = [
  { kind: "3mf", icon: "box", text: "3MF for the slicer", what: "every copy in its place" },
  { kind: "stl", icon: "mesh", text: "STL", what: "all copies in one mesh" },
  { kind: "json", icon: "braces", text: "Packing file (JSON)", what: "everything, exactly" },
  { kind: "csv", icon: "list", text: "List of copies (CSV)", what: "part, number, place" },
];

@customElement("sp-export")
export class ExportMenu extends Piece {
  @property({ attribute: false }) session!: Session;
  @state() private all = false;
  @state() private drawing = false;
  @query("sp-menu") private readonly menu!: Menu;

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.build, session.work.state, session.work.move.state];
  }

  show(): void {
    this.menu.show();
  }

  override render() {
    const held = exportHeld(this.session);
    return html`<sp-menu
      buttonClasses="btn primary"
      menuClasses="export"
      hint=${held ?? "Export (Ctrl+E)"}
      ?disabled=${held !== null}
      .button=${html`${this.drawing ? spinner : icon("download")}Export${icon("down")}`}
      .content=${() => this.entries()}
    ></sp-menu>`;
  }

  private entries(): TemplateResult {
    const { job, packing } = this.session.run.state.value;
    const shown = this.session.build.value.tray;
    const trays = packing?.trays.length ?? 1;
    const tray = trays > 1 && shown > 0 && !this.all ? shown : null;
    const verdict = verdictWords(job);
    const placed = tray === null ? packing?.placed : packing?.trays[tray - 1]?.placements.length;
    return html`<div class="row between menu-head">
        ${verdict ? badge(verdict.tone, verdict.tone === "ok" ? "Comes apart: checked" : verdict.text) : nothing}
        <span class="small faint">${copies(placed ?? 0)}</span>
      </div>
      ${
        trays > 1 && shown > 0
          ? html`<div class="seg fill s" role="group" aria-label="Which trays">
              ${this.choice(`Tray ${shown}`, false)}${this.choice(`All ${trays} trays`, true)}
            </div>`
          : nothing
      }
      ${kinds.map((kind) => this.link(kind, kind.kind === "json" ? null : tray))}
      ${
        shown > 0
          ? html`<button type="button" class="mi" role="menuitem" @click=${() => this.drawView()}>
              ${icon("picture")}<span>Picture (PNG)<span>the view as it is now</span></span>
            </button>`
          : this.link({ kind: "png", icon: "picture", text: "Picture (PNG)", what: "all trays" }, null)
      }
      <hr />
      ${this.link(
        { kind: "html", icon: "printer", text: "Printable report", what: "pictures, parts, way out, left over" },
        tray,
      )}`;
  }

  /// One tray or all; the menu stays open.
  private choice(text: string, all: boolean): TemplateResult {
    return html`<button
      type="button"
      role="menuitemradio"
      aria-checked=${this.all === all}
      data-stays
      @click=${() => {
        this.all = all;
      }}
    >
      ${text}
    </button>`;
  }

  private link(kind: Kind, tray: number | null): TemplateResult {
    return html`<a
      class="mi"
      role="menuitem"
      href=${resultUrl(this.session.id, kind.kind, tray)}
      download=${this.fileName(kind.kind, tray)}
    >
      ${icon(kind.icon)}<span>${kind.text}<span>${kind.what}</span></span>
    </a>`;
  }

  private fileName(kind: string, tray: number | null): string {
    const name = this.session.job.name.replace(/[^\p{L}\p{N} ._-]+/gu, "").trim() || "build";
    return `${name}${tray === null ? "" : ` tray ${tray}`}.${kind}`;
  }

  private async drawView(): Promise<void> {
    this.drawing = true;
    const picture = await attempt(() => shownPicture());
    this.drawing = false;
    if (!picture) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(picture);
    link.download = this.fileName("png", this.session.build.value.tray);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }
}
