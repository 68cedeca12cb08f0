/// "Take apart": the steps, the tray as it empties, what happens now, and the player below.

import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { trayTabs } from "../build/tray_tabs";
import "../common/divider";
import { icon, spinner } from "../common/icons";
import { Piece } from "../common/piece";
import type { ExportMenu } from "../shell/export_menu";
import { holdKeys } from "../shell/keys";
import { nextStep } from "../state/apart_plan";
import { type Player, playerOf } from "../state/apart_player";
import { announce } from "../state/app_state";
import type { Packing } from "../state/packing";
import { go } from "../state/route";
import { isRunning } from "../state/runner";
import type { Session } from "../state/session";
import { type Apart, apartOf, measured, selectedIn } from "./apart";
import { apartKeys } from "./apart_keys";
import type { ApartPane } from "./apart_pane";
import "./apart_pane";
import "./player_bar";
import { stepSentence } from "./sentences";
import "./step_list";
import "./step_panel";

@customElement("sp-apart")
export class ApartPage extends Piece {
  @property({ attribute: false }) session!: Session;
  /// On narrow screens: the panel that lies over the tray.
  @state() private drawer: "left" | "right" | null = null;
  @query("sp-apart-tray") private readonly pane!: ApartPane | null;
  private release: (() => void) | null = null;
  private apart: Apart | null = null;
  private madeOf: readonly unknown[] = [];
  private said = -1;

  private get player(): Player {
    return playerOf(this.session);
  }

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.build, session.source.state, this.player.state];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.release = holdKeys(
      apartKeys({
        session: () => this.session,
        player: () => this.player,
        frame: (all) => this.pane?.frame(all),
        openExport: () => document.querySelector<ExportMenu>("sp-export")?.show(),
      }),
    );
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.release?.();
    this.release = null;
    this.player.pause();
  }

  /// To who does not see it: the step that was gone to, and the end; not each one while it plays.
  protected override updated(_changed: PropertyValues): void {
    const { apart } = this;
    const { step, playing, plan } = this.player.state.value;
    if (!apart || !plan || playing || step === this.said) return;
    const first = this.said < 0;
    this.said = step;
    if (!first) announce(stepSentence(apart, step));
  }

  protected override willUpdate(): void {
    super.willUpdate();
    // Until a change is checked, the plan is that of the packing before it.
    const { stored: packing } = this.session.run.state.value;
    const number = this.trayNumber(packing);
    const tray = packing?.trays[number - 1] ?? null;
    this.player.take(tray);
    const { plan, step } = this.player.state.value;
    const { meshes } = this.session.parts;
    if (plan !== this.madeOf[0] || meshes !== this.madeOf[1]) {
      this.madeOf = [plan, meshes];
      this.apart = packing && tray && plan ? apartOf(this.session, packing, tray, plan) : null;
      if (this.apart) void this.measure(this.apart);
    }
    if (!this.apart) return;
    const selected = selectedIn(this.session, this.apart.tray);
    this.apart.ways.ask(selected && plan && this.apart.measured ? nextStep(plan, selected.index, step) : null);
  }

  /// Boxes and ways need the meshes.
  private async measure(apart: Apart): Promise<void> {
    await this.session.meshes.load(apart.parts.flatMap((part) => (part.mesh ? [part.mesh] : [])));
    if (this.apart === apart) this.apart = measured(this.session, apart);
    this.requestUpdate();
  }

  /// All side by side is not taken apart: then it is the first that can be.
  private trayNumber(packing: Packing | null): number {
    if (!packing) return 1;
    const wanted = Math.min(this.session.build.value.tray, packing.trays.length);
    if (wanted > 0) return wanted;
    return packing.trays.find((tray) => tray.steps > 0)?.number ?? 1;
  }

  override render() {
    const { session, apart } = this;
    const { stored: packing, loading } = session.run.state.value;
    if (isRunning(session.job)) return this.message("It is being packed", "How it comes apart is found at the end.");
    if (!packing || !apart) {
      if (loading || session.job.has_packing) {
        return html`<main class="empty" aria-busy="true"><p class="dim row">${spinner}Opening the build …</p></main>`;
      }
      return this.message("No build yet", "Press Pack on the Parts step.");
    }
    const tabs = trayTabs(session, packing, apart.tray.number, false);
    if (apart.plan.steps.length === 0) {
      return html`${tabs}${this.message("No plan for this tray", "It was packed without one, or the search was stopped before.")}`;
    }
    return html`${tabs}
      <main class="main build apart" data-drawer=${this.drawer ?? nothing}>
        <h1 class="out">${session.job.name}: take apart</h1>
        <aside class="side left" aria-label="Steps">
          <sp-steps .session=${session} .apart=${apart}></sp-steps>
        </aside>
        <sp-divider property="--left" side="left" label="Width of the list" most="480"></sp-divider>
        <div class="middle"><sp-apart-tray .session=${session} .apart=${apart}></sp-apart-tray></div>
        <sp-divider property="--right" side="right" label="Width of the step" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Step">
          <sp-step .session=${session} .apart=${apart}></sp-step>
        </aside>
        ${this.drawers()}
      </main>
      <sp-player .session=${session} .apart=${apart}></sp-player>`;
  }

  private drawers(): TemplateResult {
    const button = (side: "left" | "right", text: string) =>
      html`<button
        type="button"
        class="btn"
        aria-pressed=${this.drawer === side}
        @click=${() => {
          this.drawer = this.drawer === side ? null : side;
        }}
      >
        ${icon(side === "left" ? "list" : "info")}${text}
      </button>`;
    return html`<div class="drawers">${button("left", "Steps")}${button("right", "This step")}</div>`;
  }

  private message(title: string, text: string): TemplateResult {
    return html`<main class="empty">
      <h2>${title}</h2>
      <p class="dim">${text}</p>
      <div class="row">
        <button
          type="button"
          class="btn primary"
          @click=${() => go({ page: "job", id: this.session.id, step: "build" })}
        >
          To the build
        </button>
      </div>
    </main>`;
  }
}
