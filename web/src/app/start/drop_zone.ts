/// Where files and folders are dropped, or chosen. The whole page takes what is dropped; the zone shows it.

import { html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { chooseFiles } from "../common/files_button";
import { icon, spinner } from "../common/icons";
import { dragged, ofDrop } from "../common/picked_files";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { PickedFile } from "../state/file_names";
import { jobFromFiles, jobFromSample } from "../state/new_job";
import { counted } from "../words/numbers";
import { emptyTray } from "./empty_tray";

@customElement("sp-drop")
export class DropZone extends Piece {
  /// Something else on the page is more urgent.
  @property({ type: Boolean }) second = false;
  /// Things over the zone; 0: none.
  @state() private over = 0;
  @state() private busy = false;

  protected override stores() {
    return [app];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("dragover", this.dragOver);
    addEventListener("dragleave", this.dragLeave);
    addEventListener("drop", this.drop);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("dragover", this.dragOver);
    removeEventListener("dragleave", this.dragLeave);
    removeEventListener("drop", this.drop);
  }

  override render() {
    const sample = app.value.info?.samples ?? false;
    return html`<div class="drop ${this.over > 0 ? "over" : ""}">
      ${emptyTray}
      <h2>${this.over > 0 ? this.dropText() : "Drop files or a folder here"}</h2>
      <p class="dim">STL, 3MF, OBJ, PLY, OFF, or a job or set file with its meshes</p>
      <div class="row wrap">
        <button
          type="button"
          class="btn l ${this.second ? "" : "primary"}"
          ?disabled=${this.busy}
          @click=${() => chooseFiles((files) => this.take(files))}
        >
          ${this.busy ? spinner : icon("file")}Choose files
        </button>
        <button
          type="button"
          class="btn l"
          ?disabled=${this.busy}
          @click=${() => chooseFiles((files) => this.take(files), { folder: true })}
        >
          ${icon("folder")}Choose a folder
        </button>
        ${
          sample
            ? html`<button
                type="button"
                class="btn l ghost accent"
                ?disabled=${this.busy}
                @click=${() => this.begin(jobFromSample())}
              >
                Try the sample
              </button>`
            : nothing
        }
      </div>
    </div>`;
  }

  /// A folder counts as one thing until it is opened.
  private dropText(): string {
    return this.over === 1 ? "Drop to begin" : `Drop to add ${counted(this.over, "file")}`;
  }

  private readonly dragOver = (event: DragEvent) => {
    const count = dragged(event);
    if (count === 0) return;
    event.preventDefault();
    this.over = count;
  };

  private readonly dragLeave = (event: DragEvent) => {
    if (event.relatedTarget === null) this.over = 0;
  };

  private readonly drop = (event: DragEvent) => {
    event.preventDefault();
    this.over = 0;
    void ofDrop(event).then((files) => this.take(files));
  };

  private take(files: PickedFile[]): void {
    if (files.length > 0) void this.begin(jobFromFiles(files));
  }

  private async begin(what: Promise<void>): Promise<void> {
    this.busy = true;
    await what;
    this.busy = false;
  }
}
