/// The build: while it packs, and what came of it.

import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import "../common/divider";
import { icon } from "../common/icons";
import type { Menu } from "../common/menu";
import { Piece } from "../common/piece";
import type { ExportMenu } from "../shell/export_menu";
import { holdKeys } from "../shell/keys";
import { announce } from "../state/app_state";
import type { Layers } from "../state/layers";
import type { Packing } from "../state/packing";
import type { Session } from "../state/session";
import { traySize } from "../state/tray_size";
import { stateWords, verdictWords } from "../words/jobs";
import { copies, percent } from "../words/numbers";
import { buildKeys } from "./build_keys";
import "./build_list";
import { type BuildPart, liveParts, packedParts } from "./build_parts";
import { moveKeys } from "./change_keys";
import "./improve_panel";
import "./layer_strip";
import { liveFigures } from "./live_figures";
import { liveTabs } from "./live_tabs";
import "./move_panel";
import { nothingThere } from "./nothing_there";
import "./packing_panel";
import "./result_panel";
import type { TrayPane } from "./tray_pane";
import "./tray_pane";
import { trayTabs } from "./tray_tabs";
import "./trays_overview";

interface Shown {
  readonly live: boolean;
  readonly parts: readonly BuildPart[];
  readonly tray: number;
  readonly tabs: TemplateResult | typeof nothing;
  readonly layers: Layers | null;
  /// mm, of the plot.
  readonly height: number;
  readonly average: number;
  readonly panel: TemplateResult;
}

@customElement("sp-build")
export class BuildPage extends Piece {
  @property({ attribute: false }) session!: Session;
  /// On narrow screens: the panel that lies over the tray.
  @state() private drawer: "left" | "right" | null = null;
  @query("sp-tray") private readonly pane!: TrayPane | null;
  private release: (() => void) | null = null;
  private releaseMove: (() => void) | null = null;
  private liveKeys: boolean | null = null;
  private saidTenth = -1;
  private wasRunning = false;
  private parts: readonly BuildPart[] = [];
  private madeOf: readonly unknown[] = [];

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.build, session.source.state, session.work.move.state];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.release?.();
    this.release = null;
    this.liveKeys = null;
    this.releaseMove?.();
    this.releaseMove = null;
    this.session.work.move.end();
  }

  protected override updated(_changed: PropertyValues): void {
    const live = this.session.run.packs;
    this.holdMoveKeys();
    if (live !== this.liveKeys) {
      this.release?.();
      this.release = holdKeys(
        buildKeys(
          {
            session: () => this.session,
            frame: (all) => this.pane?.frame(all),
            openExport: () => document.querySelector<ExportMenu>("sp-export")?.show(),
            openPack: () => this.querySelector<Menu>("sp-menu.pack-again")?.show(),
          },
          live,
        ),
      );
      this.liveKeys = live;
    }
    this.say(live);
  }

  /// While a copy is moved its keys come first; on narrow screens its panel comes into sight.
  private holdMoveKeys(): void {
    const { active } = this.session.work.move;
    if (active && !this.releaseMove) {
      this.releaseMove = holdKeys(moveKeys(() => this.session));
      this.drawer = "right";
    } else if (!active) {
      this.releaseMove?.();
      this.releaseMove = null;
    }
  }

  /// To who does not see it: each tenth, and the end.
  private say(live: boolean): void {
    const { progress } = this.session.run.live;
    if (live && progress?.phase === "search" && progress.total > 0) {
      const tenth = Math.floor((10 * progress.done) / progress.total);
      if (tenth > this.saidTenth && tenth > 0) announce(`${tenth * 10} percent of the copies are placed.`);
      this.saidTenth = tenth;
    }
    if (this.wasRunning && !live) {
      const { job, packing } = this.session.run.state.value;
      const verdict = verdictWords(job)?.text ?? stateWords(job).text;
      if (packing) announce(`Done. ${copies(packing.placed)} placed, ${percent(packing.density)} filled. ${verdict}.`);
      else announce(stateWords(job).text);
    }
    this.wasRunning = live;
  }

  override render() {
    const { session } = this;
    const { packing, loading } = session.run.state.value;
    // What was seen to land stays until the finished build is there.
    const landed = loading && !packing && session.run.live.standing > 0;
    // What is made better is looked at until it is made better.
    const { curve, standing } = session.run.live;
    const improves =
      session.run.packs && session.run.doing === "improve" && (standing === 0 || curve.points.length < 2);
    if ((session.run.packs || landed) && !(improves && packing)) return this.live();
    if (!packing) return nothingThere(session);
    const parts = this.partsOf(packing, () => packedParts(session, packing));
    const tray = packing.trays.length < 2 ? 1 : Math.min(session.build.value.tray, packing.trays.length);
    return tray === 0 ? this.all(packing, parts) : this.one(packing, parts, tray);
  }

  /// Worked out anew only when the draft, the packing or the meshes are others.
  private partsOf(of: object, make: () => BuildPart[]): readonly BuildPart[] {
    const { meshes } = this.session.parts;
    if (this.madeOf[0] !== of || this.madeOf[1] !== meshes) {
      this.madeOf = [of, meshes];
      this.parts = make();
    }
    return this.parts;
  }

  private live(): TemplateResult {
    const { session } = this;
    const { live } = session.run;
    const { follow, tray: wanted } = session.build.value;
    const parts = this.partsOf(session.draft, () => liveParts(session));
    const tray = follow || wanted === 0 ? live.current : wanted;
    const size = traySize(session.draft, session.info, session.parts.meshes) ?? [100, 100, 100];
    const figures = liveFigures(session, live, parts, tray, size);
    return this.frame({
      live: true,
      parts,
      tray,
      tabs: live.trays.size > 1 ? liveTabs(session, tray) : nothing,
      layers: figures.layers,
      height: Math.max(size[2], figures.height),
      average: figures.density,
      panel:
        session.run.doing === "improve"
          ? html`<sp-improve .session=${session}></sp-improve>`
          : html`<sp-packing .session=${session} .figures=${figures}></sp-packing>`,
    });
  }

  private one(packing: Packing, parts: readonly BuildPart[], tray: number): TemplateResult {
    const { session } = this;
    const own = packing.trays[tray - 1];
    return this.frame({
      live: false,
      parts,
      tray,
      tabs: trayTabs(session, packing, tray),
      layers: own?.layers ?? null,
      height: Math.max(packing.size[2], own?.height ?? 0),
      average: own?.density ?? 0,
      panel: this.resultPanel(packing, parts, tray),
    });
  }

  private resultPanel(packing: Packing, parts: readonly BuildPart[], tray: number): TemplateResult {
    const { session } = this;
    if (session.run.packs) return html`<sp-improve .session=${session}></sp-improve>`;
    return session.work.move.active
      ? html`<sp-move .session=${session} .packing=${packing} .parts=${parts}></sp-move>`
      : html`<sp-result .session=${session} .packing=${packing} .parts=${parts} .tray=${tray}></sp-result>`;
  }

  /// List, tray, layers, figures: the same elements while it packs and after, so that the view stays as it is.
  private frame(shown: Shown): TemplateResult {
    const { session } = this;
    const { live, parts, tray } = shown;
    return html`${shown.tabs}
      <main class="main build" data-drawer=${this.drawer ?? nothing}>
        <h1 class="out">${session.job.name}: build</h1>
        <aside class="side left" aria-label="Parts">
          <sp-build-list .session=${session} .parts=${parts} ?live=${live} .tray=${tray}></sp-build-list>
        </aside>
        <sp-divider property="--left" side="left" label="Width of the list" most="480"></sp-divider>
        <div class="vsplit">
          <sp-tray .session=${session} .parts=${parts} ?live=${live} .tray=${tray}></sp-tray>
          <sp-layers
            .session=${session}
            ?live=${live}
            .layers=${shown.layers}
            .height=${shown.height}
            .average=${shown.average}
          ></sp-layers>
        </div>
        <sp-divider property="--right" side="right" label="Width of the figures" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label=${live ? "Packing" : "Build"}>${shown.panel}</aside>
        ${this.drawers()}
      </main>`;
  }

  private all(packing: Packing, parts: readonly BuildPart[]): TemplateResult {
    const { session } = this;
    return html`${trayTabs(session, packing, 0)}
      <main class="main build all" data-drawer=${this.drawer ?? nothing}>
        <h1 class="out">${session.job.name}: all trays</h1>
        <sp-trays .session=${session} .packing=${packing} .parts=${parts}></sp-trays>
        <sp-divider property="--right" side="right" label="Width of the figures" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Build">${this.resultPanel(packing, parts, 0)}</aside>
        ${this.drawers()}
      </main>`;
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
    return html`<div class="drawers">${button("left", "Parts")}${button("right", "Figures")}</div>`;
  }
}
