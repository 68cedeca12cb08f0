/// The tray in 3D, and over it its bars (tray_bars.ts) and the search.

import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { CopyKey, TrayView } from "../../view/view";
import { lockedIn } from "../change/locks";
import { iconButton } from "../common/bits";
import { Piece } from "../common/piece";
import { offerPicture } from "../shell/shown_picture";
import { app } from "../state/app_state";
import { toggledSelection } from "../state/build_view";
import type { Session } from "../state/session";
import { trayViews } from "../state/views";
import { copies, counted, percent } from "../words/numbers";
import type { BuildPart } from "./build_parts";
import "./find_box";
import { closeCopies, moveHint, moveLegend } from "./move_bars";
import { colourBar, hideMenu, justPlaced, type Legend, lookMenu, sectionBar } from "./tray_bars";
import { TrayScene } from "./tray_scene";

@customElement("sp-tray")
export class TrayPane extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];
  @property({ type: Boolean }) live = false;
  /// From 1 on.
  @property({ type: Number }) tray = 1;
  @query(".stage") private readonly stage!: HTMLElement;
  @state() private lost = false;
  @state() private failed = "";
  @state() private hovered: CopyKey | null = null;
  @state() private legend: Legend = null;
  private view: TrayView | null = null;
  private scene: TrayScene | null = null;
  private loading = false;
  private noPicture: (() => void) | null = null;
  /// To be called once the tray is on the screen: then pictures of parts are drawn.
  private drawn: () => void = () => {};

  protected override stores() {
    const { session } = this;
    const { work } = session;
    return [
      session.run.state,
      session.build,
      work.state,
      work.move.state,
      session.source.state,
      session.meshes.state,
      app,
    ];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.end();
  }

  protected override updated(_changed: PropertyValues): void {
    if (this.view && this.scene) this.sync(this.view, this.scene);
    else void this.begin();
  }

  private async begin(): Promise<void> {
    if (this.loading || this.failed) return;
    this.loading = true;
    this.drawn = this.session.meshes.holdPictures();
    try {
      const { createTrayView } = await trayViews();
      if (!this.isConnected) return;
      const { build } = this.session;
      this.view = createTrayView(
        this.stage,
        {
          select: (copy, add) => this.select(copy, add),
          hover: (copy) => {
            this.hovered = copy;
          },
          section: (at) => {
            const section = build.value.section;
            if (section) build.set({ section: { ...section, at } });
          },
          move: (by, ended) => this.session.work.move.dragged(by, ended),
          shown: () => this.drawn(),
          paced: () => this.scene?.paced(),
          lost: (lost) => {
            this.lost = lost;
          },
        },
        app.value.theme,
      );
      this.scene = new TrayScene(this.session, this.view, () => this.requestUpdate());
      this.noPicture = offerPicture(async () => {
        const { clientWidth, clientHeight } = this.stage;
        if (!this.view) throw new Error("There is no picture yet.");
        return this.view.picture(clientWidth * 2, clientHeight * 2);
      });
      this.requestUpdate();
    } catch {
      this.drawn();
      this.failed = "This browser draws no 3D graphics. Lists, figures and export work without them.";
    } finally {
      this.loading = false;
    }
  }

  private end(): void {
    this.drawn();
    this.noPicture?.();
    this.view?.dispose();
    this.view = null;
    this.scene = null;
  }

  private sync(view: TrayView, scene: TrayScene): void {
    const { session } = this;
    const { packing } = session.run.state.value;
    view.setTheme(app.value.theme);
    const tray = packing?.trays[this.tray - 1];
    if (this.live) scene.showLive(this.parts, session.run.live, this.tray, session.run.doing !== "improve");
    else if (packing && tray) scene.showPacked(this.parts, packing, tray, true);
    const { work } = session;
    scene.showView(session.build.value, this.live ? [] : lockedIn(work.state.value.locks, this.tray));
    scene.showMove(work.move.state.value, tray, closeCopies(work.move.state.value));
    // Beside a copy that is moved a name would lie over the handles.
    scene.showLabels(this.parts, work.move.active ? [] : session.build.value.selected, this.hovered);
    const legend = view.legend();
    if (JSON.stringify(legend) !== JSON.stringify(this.legend)) this.legend = legend;
  }

  private select(copy: CopyKey | null, add: boolean): void {
    const { build, work } = this.session;
    if (work.move.active) return;
    if (!copy) {
      if (!add) build.set({ selected: [] });
      return;
    }
    build.set({ selected: add ? toggledSelection(build.value.selected, copy) : [copy] });
  }

  /// For the keys: the selection, or all.
  frame(all: boolean): void {
    const { selected } = this.session.build.value;
    this.view?.frame(all || selected.length === 0 ? null : selected);
  }

  override render() {
    const { session } = this;
    const { build } = session;
    const { find } = build.value;
    const moving = session.work.move.active;
    return html`<section class="view tray" aria-label="Tray">
      <div class="stage"></div>
      <p class="out">${this.summary()}</p>
      <div class="hud tl">
        ${this.live ? (session.run.doing === "improve" ? nothing : justPlaced(session, this.parts)) : moving ? moveLegend() : colourBar(session, this.legend)}
      </div>
      <div class="hud tr">
        <div class="glass">
          ${iconButton("frame", "Frame all (Shift+F)", () => this.frame(true), "float")} ${lookMenu((side) => this.view?.look(side))} ${hideMenu(session)}
          ${iconButton("find", "Find a copy or part (/)", () => build.set({ find: find === null ? "" : null }), "float")}
        </div>
      </div>
      ${find === null ? nothing : html`<sp-find .session=${this.session} .parts=${this.parts} .tray=${this.tray} @found=${() => this.frame(false)}></sp-find>`}
      ${this.live ? nothing : html`<div class="hud bc">${moving ? moveHint() : sectionBar(session)}</div>`}
      ${
        this.failed || this.lost
          ? html`<div class="lost">
              <p>${this.failed || "The graphics card took the picture away."}</p>
              ${this.failed ? nothing : html`<button type="button" class="btn" @click=${this.again}>Draw again</button>`}
            </div>`
          : nothing
      }
    </section>`;
  }

  private again(): void {
    this.end();
    this.lost = false;
    this.requestUpdate();
  }

  /// For who does not see the picture.
  private summary(): string {
    const { packing } = this.session.run.state.value;
    const { selected } = this.session.build.value;
    const chosen = selected.length > 0 ? ` ${copies(selected.length)} selected.` : "";
    if (this.live) return `${copies(this.session.run.live.standing)} placed so far.${chosen}`;
    const tray = packing?.trays[this.tray - 1];
    if (!tray) return "";
    const kinds = new Set(tray.placements.map((placement) => placement.part)).size;
    return `${copies(tray.placements.length)} of ${counted(kinds, "part")}, ${percent(tray.density)} filled.${chosen}`;
  }
}
