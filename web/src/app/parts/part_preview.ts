/// The part that is looked at: its shape, size and what was mended, and below it how it may stand.

import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { Mesh } from "../../api/types";
import { partColour } from "../../view/palette";
import type { PartView } from "../../view/view";
import { segments } from "../common/bits";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { DraftPart } from "../state/draft";
import { mmPerUnit, partSize, partVolume } from "../state/part_size";
import type { Session } from "../state/session";
import { partViews } from "../state/views";
import { counted, type LengthUnit, size, volume } from "../words/numbers";
import { sentence } from "../words/sentence";
import "./part_card";
import { meshFinder, nameOf } from "./rows";

interface Shown {
  readonly part: DraftPart;
  readonly index: number;
  readonly mesh: Mesh | null;
}

@customElement("sp-part-preview")
export class PartPreview extends Piece {
  @property({ attribute: false }) session!: Session;
  @query(".stage") private readonly stage!: HTMLElement;
  private view: PartView | null = null;
  private loading = false;
  private shownAs = "";

  protected override stores() {
    const { session } = this;
    return [session.state, session.view, session.source.state, session.meshes.state, app];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.view?.dispose();
    this.view = null;
    this.shownAs = "";
  }

  private get shown(): Shown | null {
    const { current } = this.session.view.value;
    const { draft, parts } = this.session;
    const index = draft.parts.findIndex((part) => part.key === current);
    const part = draft.parts[index];
    return part ? { part, index, mesh: meshFinder(parts.meshes)(part) } : null;
  }

  protected override updated(_changed: PropertyValues): void {
    if (this.view) this.draw(this.view);
    else void this.begin();
  }

  private async begin(): Promise<void> {
    if (this.loading || !this.shown) return;
    this.loading = true;
    const { createPartView } = await partViews();
    this.loading = false;
    if (!this.isConnected) return;
    const view = createPartView(this.stage, app.value.theme);
    this.view = view;
    this.draw(view);
  }

  private draw(view: PartView): void {
    view.setTheme(app.value.theme);
    const shown = this.shown;
    const mesh = shown?.mesh;
    if (!shown || !mesh) {
      if (this.shownAs !== "") view.show(null, 1, "#888888", "any");
      this.shownAs = "";
      return;
    }
    const { part, index } = shown;
    const scale = mmPerUnit(part, mesh, this.session.draft);
    const stands = part.stands.kind === "matrices" ? "axes" : part.stands.kind;
    const colour = partColour(index);
    const as = [part.key, mesh.id, mesh.volume, mesh.triangles, scale, stands, colour].join("|");
    const coarse = this.session.meshes.mesh(mesh);
    if (as === this.shownAs) return;
    if (coarse) view.show(coarse, scale, colour, stands);
    else void this.session.meshes.load([mesh]);
    this.shownAs = as;
    void this.session.meshes.fine(mesh).then((fine) => {
      if (fine && this.shownAs === as) this.view?.show(fine, scale, colour, stands);
    });
  }

  override render() {
    const shown = this.shown;
    const { chosen } = this.session.view.value;
    return html`<section class="view preview" aria-label="Selected part">
      <div class="stage"></div>
      ${shown ? this.words(shown) : nothing}
      ${shown || chosen.size > 0 ? html`<sp-part-card .session=${this.session}></sp-part-card>` : nothing}
    </section>`;
  }

  private words({ part, mesh }: Shown): TemplateResult {
    const { draft, view } = this.session;
    const unit: LengthUnit = view.value.inch ? "inch" : "mm";
    return html`<div class="hud tl wide">
      <div class="cut grow">
        <h2 class="cut">${nameOf(part, mesh)}</h2>
        ${
          mesh
            ? html`<p class="dim small cut">
                  ${size(partSize(part, mesh, draft), true, unit)} · ${volume(partVolume(part, mesh, draft))}
                </p>
                <p class="dim small facts hide-s">${facts(mesh)}</p>`
            : html`<p class="dim small cut">${part.file}</p>`
        }
      </div>
      ${segments<LengthUnit>(
        "Unit of the sizes shown",
        [
          { value: "mm", text: "mm" },
          { value: "inch", text: "inch" },
        ],
        unit,
        (next) => view.set({ inch: next === "inch" }),
        "s",
      )}
    </div>`;
  }
}

/// "3 598 triangles · closed · nothing mended", or what was.
function facts(mesh: Mesh): TemplateResult {
  const closed = mesh.watertight ? "closed" : "not closed";
  const bodies = mesh.shells > 1 ? ` · ${counted(mesh.shells, "body", "bodies")}` : "";
  const head = `${counted(mesh.triangles, "triangle")} · ${closed}${bodies}`;
  if (mesh.repairs.length === 0) return html`${head} · nothing mended`;
  return html`${head} ·
    <details class="repairs">
      <summary class="link">${counted(mesh.repairs.length, "thing")} mended</summary>
      <ul>
        ${mesh.repairs.map((repair) => html`<li>${sentence(repair)}</li>`)}
      </ul>
    </details>`;
}
