/// The tray in 3D as it comes apart, and what floats over it.

import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { CopyKey, TrayView } from "../../view/view";
import "../build/find_box";
import { TrayScene } from "../build/tray_scene";
import { Piece } from "../common/piece";
import { offerPicture } from "../shell/shown_picture";
import { playerOf } from "../state/apart_player";
import { app } from "../state/app_state";
import { isHidden } from "../state/build_view";
import { copyId } from "../state/live_run";
import type { Session } from "../state/session";
import { trayViews } from "../state/views";
import { type Apart, select, selectedIn } from "./apart";
import { aloneBar, legend, lookBar, showBar } from "./apart_bars";
import { ApartScene } from "./apart_scene";
import { stepSentence } from "./sentences";

@customElement("sp-apart-tray")
export class ApartPane extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) apart!: Apart;
  @query(".stage") private readonly stage!: HTMLElement;
  @state() private lost = false;
  @state() private failed = "";
  @state() private hovered: CopyKey | null = null;
  private view: TrayView | null = null;
  private trays: TrayScene | null = null;
  private scene: ApartScene | null = null;
  private loading = false;
  private noPicture: (() => void) | null = null;
  private noClock: (() => void) | null = null;
  private hiddenOf: readonly unknown[] = [];
  private concealed: (copy: CopyKey) => boolean = () => false;

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.build, this.apart.ways.state, this.player.state, app];
  }

  private get player() {
    return playerOf(this.session);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // With every frame only the picture is brought up to date, not the page over it.
    this.noClock = this.player.clock.subscribe(() => this.sync());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.noClock?.();
    this.end();
  }

  protected override updated(_changed: PropertyValues): void {
    if (this.view) this.sync();
    else void this.begin();
  }

  private async begin(): Promise<void> {
    if (this.loading || this.failed) return;
    this.loading = true;
    try {
      const { createTrayView } = await trayViews();
      if (!this.isConnected) return;
      const view = createTrayView(
        this.stage,
        {
          select: (copy) => this.select(copy),
          hover: (copy) => {
            this.hovered = copy;
          },
          paced: () => this.trays?.paced(),
          lost: (lost) => {
            this.lost = lost;
          },
        },
        app.value.theme,
      );
      this.view = view;
      this.trays = new TrayScene(this.session, view, () => this.requestUpdate());
      this.scene = new ApartScene(view);
      this.noPicture = offerPicture(() => view.picture(this.stage.clientWidth * 2, this.stage.clientHeight * 2));
      this.requestUpdate();
    } catch {
      this.failed = "This browser draws no 3D graphics. The list of steps and the export work without them.";
    } finally {
      this.loading = false;
    }
  }

  private end(): void {
    this.noPicture?.();
    this.view?.dispose();
    this.view = null;
    this.trays = null;
    this.scene = null;
  }

  private again(): void {
    this.end();
    this.lost = false;
    this.requestUpdate();
  }

  private sync(): void {
    const { view, trays, scene, apart, session } = this;
    if (!view || !trays || !scene) return;
    view.setTheme(app.value.theme);
    trays.showPacked(apart.parts, apart.packing, apart.tray);
    if (trays.placed === "" || !apart.measured) return;
    scene.show(apart, trays.placed, {
      time: this.player.time,
      player: this.player.state.value,
      selected: selectedIn(session, apart.tray),
      hovered: this.hovered,
      blockers: this.blockers(),
      hidden: this.hiddenTest(),
    });
  }

  /// Those that still stand.
  private blockers(): number[] {
    const { step } = this.player.state.value;
    const { found } = this.apart.ways.state.value;
    return (found ?? []).filter((own) => own.step >= step).map((own) => own.placement);
  }

  private hiddenTest(): (copy: CopyKey) => boolean {
    const build = this.session.build.value;
    const sets = [build.hiddenParts, build.hiddenCopies, build.isolated];
    if (!sets.every((set, i) => set === this.hiddenOf[i])) {
      this.hiddenOf = sets;
      this.concealed = (copy) => isHidden(build, copy);
    }
    return this.concealed;
  }

  private select(copy: CopyKey | null): void {
    const placement = copy ? this.apart.tray.byId.get(copyId(copy)) : null;
    select(this.session, placement ?? null);
  }

  /// For the keys: what is selected, else what leaves, or all.
  frame(all: boolean): void {
    const { apart, player } = this;
    const selected = selectedIn(this.session, apart.tray);
    const leaving = apart.plan.steps[player.state.value.step]?.placements ?? [];
    const which = selected ? [selected] : leaving.flatMap((index) => apart.tray.placements[index] ?? []);
    this.view?.frame(all || which.length === 0 ? null : which);
  }

  override render() {
    const { session, apart, player } = this;
    const { find } = session.build.value;
    const { step, alone } = player.state.value;
    return html`<section class="view tray" aria-label="Tray coming apart">
      <div class="stage"></div>
      <p class="out">${stepSentence(apart, step)}</p>
      <div class="hud tl">${showBar(player)}</div>
      <div class="hud tr">${lookBar(
        session,
        (side) => this.view?.look(side),
        () => this.frame(true),
      )}</div>
      ${find === null ? nothing : html`<sp-find .session=${session} .parts=${apart.parts} .tray=${apart.tray.number} @found=${() => this.frame(false)}></sp-find>`}
      <div class="hud bl">${legend(apart, player.state.value, selectedIn(session, apart.tray), this.blockers().length > 0)}</div>
      ${alone === null ? nothing : aloneBar(apart, player, alone)}
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
}
