/// The parts and how they are to be packed: the list, the part that is looked at, the settings, and what to expect.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import "../common/divider";
import { icon } from "../common/icons";
import type { Menu } from "../common/menu";
import { dragged, ofDrop } from "../common/picked_files";
import { Piece } from "../common/piece";
import { holdKeys, type Key } from "../shell/keys";
import { removeParts } from "../state/draft_edit";
import type { Session } from "../state/session";
import { counted } from "../words/numbers";
import "./dock";
import "./part_preview";
import "./parts_list";
import "./settings_panel";

@customElement("sp-parts")
export class PartsPage extends Piece {
  @property({ attribute: false }) session!: Session;
  @state() private over = 0;
  /// On narrow screens: the panel that lies over the preview.
  @state() private drawer: "left" | "right" | null = "left";
  private release: (() => void) | null = null;

  private readonly keys: readonly Key[] = [
    { keys: ["Ctrl+Enter"], does: "pack", run: () => this.pack() },
    { keys: ["Ctrl+Z"], does: "undo", run: () => this.session.undo() },
    { keys: ["Ctrl+Shift+Z", "Ctrl+Y"], does: "redo", run: () => this.session.redo() },
    {
      keys: ["/"],
      does: "find a part",
      run: () => this.session.view.set({ find: this.session.view.value.find ?? "" }),
    },
    { keys: ["Del"], does: "leave out the chosen parts", run: () => this.leaveOut() },
    { keys: ["Esc"], does: "let go", run: () => this.session.view.set({ chosen: new Set(), find: null }) },
  ];

  protected override stores() {
    return [this.session.run.state];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.release = holdKeys(this.keys);
    if (!this.session.locked) this.session.saver.look();
    addEventListener("dragover", this.dragOver);
    addEventListener("dragleave", this.dragLeave);
    addEventListener("drop", this.drop);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.release?.();
    removeEventListener("dragover", this.dragOver);
    removeEventListener("dragleave", this.dragLeave);
    removeEventListener("drop", this.drop);
  }

  override render() {
    const { session } = this;
    const locked = session.locked;
    return html`${locked ? this.lockedBanner() : nothing}
      <main class="main parts" data-drawer=${this.drawer ?? nothing}>
        <h1 class="out">${session.job.name}: parts</h1>
        <aside class="side left" aria-label="Parts" ?inert=${locked}>
          <sp-parts-list .session=${session}></sp-parts-list>
        </aside>
        <sp-divider property="--parts" side="left" label="Width of the list" least="480"></sp-divider>
        <sp-part-preview .session=${session} ?inert=${locked}></sp-part-preview>
        <sp-divider property="--right" side="right" label="Width of the settings" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Settings" ?inert=${locked}>
          <sp-settings .session=${session}></sp-settings>
        </aside>
        <div class="drawers">
          ${this.drawerButton("left", "Parts")}${this.drawerButton("right", "Settings")}
        </div>
        ${
          this.over > 0 ? html`<div class="over-all"><h2>Drop to add ${counted(this.over, "file")}</h2></div>` : nothing
        }
      </main>
      <sp-dock .session=${session}></sp-dock>`;
  }

  /// Where copies are locked, it is asked which way.
  private pack(): void {
    const menu = this.querySelector<Menu>("sp-menu.pack-again");
    if (menu) menu.show();
    else void this.session.pack();
  }

  private lockedBanner(): TemplateResult {
    if (this.session.run.checking) {
      return html`<div class="banner info" role="status">
        ${icon("clock")}
        <span class="grow"><b>The build is being checked.</b> Parts and settings can be changed once that is done.</span>
      </div>`;
    }
    return html`<div class="banner info" role="status">
      ${icon("clock")}
      <span class="grow"><b>This job is being packed.</b> Parts and settings can be changed once it is done or stopped.</span>
      <a class="btn s" href=${`#/job/${this.session.id}/build`}>Watch it</a>
      <button type="button" class="btn s" @click=${() => this.session.stop()}>Stop it</button>
    </div>`;
  }

  private drawerButton(side: "left" | "right", text: string): TemplateResult {
    return html`<button
      type="button"
      class="btn"
      aria-pressed=${this.drawer === side}
      @click=${() => {
        this.drawer = this.drawer === side ? null : side;
      }}
    >
      ${icon(side === "left" ? "list" : "settings")}${text}
    </button>`;
  }

  private leaveOut(): void {
    const { chosen, current } = this.session.view.value;
    const keys = chosen.size > 0 ? chosen : new Set(current === null ? [] : [current]);
    if (keys.size === 0) return;
    const text = keys.size === 1 ? "1 part is left out." : `${keys.size} parts are left out.`;
    this.session.editWithToast(text, (draft) => removeParts(draft, keys));
  }

  private readonly dragOver = (event: DragEvent) => {
    const count = dragged(event);
    if (count === 0 || this.session.locked) return;
    event.preventDefault();
    this.over = count;
  };

  private readonly dragLeave = (event: DragEvent) => {
    if (event.relatedTarget === null) this.over = 0;
  };

  private readonly drop = (event: DragEvent) => {
    event.preventDefault();
    this.over = 0;
    if (this.session.locked) return;
    void ofDrop(event).then((files) => this.session.addFiles(files));
  };
}
