/// The parts of the build: how many of each stand, and while it packs how far each is. A click selects a part's copies,
/// the eye hides them. Only the rows in sight are drawn.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { partColour } from "../../view/palette";
import type { CopyKey } from "../../view/view";
import { bar, iconButton, picture } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { styles } from "../common/styles";
import { sightOf } from "../parts/sight";
import { app } from "../state/app_state";
import { toggledPart } from "../state/build_view";
import type { Session } from "../state/session";
import { count } from "../words/numbers";
import { type BuildPart, placedCounts, shownTrays } from "./build_parts";
import "./left_over_list";
import { lockMark, partMenu, trayLockMenu } from "./lock_menus";

const rowHeight = 40;

@customElement("sp-build-list")
export class BuildList extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];
  @property({ type: Boolean }) live = false;
  @property({ type: Number }) tray = 1;
  @query(".scroll") private readonly scroller!: HTMLElement;
  private top = 0;
  private height = 900;
  private followed = -1;
  private readonly sizes = new ResizeObserver(() => {
    this.height = this.scroller.clientHeight;
    this.requestUpdate();
  });

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.build, session.work.state, session.meshes.state, app];
  }

  protected override firstUpdated(): void {
    this.sizes.observe(this.scroller);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sizes.disconnect();
  }

  protected override updated(): void {
    if (!this.live) return;
    // The part that is placed now stays in sight.
    const now = this.session.run.live.newest?.copy.part ?? -1;
    if (now === this.followed) return;
    this.followed = now;
    const y = this.parts.findIndex((part) => part.index === now) * rowHeight;
    const { scrollTop, clientHeight } = this.scroller;
    if (y >= 0 && (y < scrollTop || y + rowHeight > scrollTop + clientHeight)) {
      this.scroller.scrollTop = y - clientHeight / 2;
    }
  }

  override render() {
    const { session, live } = this;
    const { packing } = session.run.state.value;
    const counts = live ? session.run.live.counts() : placedCounts(packing ? shownTrays(packing, this.tray) : []);
    const asked = this.parts.reduce((sum, part) => sum + part.count, 0);
    const placed = [...counts.values()].reduce((sum, own) => sum + own, 0);
    const total = live ? Math.max(asked, session.run.live.progress?.total ?? 0) : (packing?.copies ?? asked);
    const sight = sightOf(
      this.parts.map(() => rowHeight),
      this.top,
      this.height,
    );
    return html`<div class="head">
        <h2 class="grow">Parts</h2>
        <span class="count">${count(placed)} of ${count(total)}${live ? " placed" : ""}</span>
        ${live ? nothing : iconButton("find", "Find (/)", () => session.build.set({ find: "" }), "s")}
        ${live ? nothing : trayLockMenu(session, this.tray)}
      </div>
      <div
        class="scroll"
        @scroll=${() => {
          this.top = this.scroller.scrollTop;
          this.requestUpdate();
        }}
      >
        <div role="list" aria-label="Parts">
          <div role="presentation" ${styles({ height: `${sight.before}px` })}></div>
          ${repeat(
            this.parts.slice(sight.first, sight.last),
            (part) => part.index,
            (part) => this.row(part, counts.get(part.index) ?? 0),
          )}
          <div role="presentation" ${styles({ height: `${sight.after}px` })}></div>
        </div>
      </div>
      ${live ? nothing : html`<sp-left-over .session=${session} .parts=${this.parts}></sp-left-over>`}`;
  }

  private row(part: BuildPart, placed: number): TemplateResult {
    const { session, live } = this;
    const { selected, hiddenParts } = session.build.value;
    const newest = session.run.doing === "improve" ? null : session.run.live.newest;
    const isSelected = live ? newest?.copy.part === part.index : selected.some((copy) => copy.part === part.index);
    const hidden = hiddenParts.has(part.index);
    const { mesh } = part;
    const shot = picture(mesh ? session.meshes.picture(mesh, partColour(part.index), app.value.theme) : null);
    if (live) {
      const done = placed >= part.count;
      return html`<div class="li ${isSelected ? "sel" : ""}" role="listitem">
        ${shot}
        <div class="cut">
          <div class="cut">${part.name}</div>
          ${bar(part.count > 0 ? placed / part.count : 0, null, done ? "done" : "")}
        </div>
        <span class="dim num">${count(placed)} <span class="faint">/ ${count(part.count)}</span></span>
      </div>`;
    }
    const hide = hidden ? `Show ${part.name}` : `Hide ${part.name}`;
    return html`<div class="li ${isSelected ? "sel" : ""} ${hidden ? "past" : ""}" role="listitem">
      <button
        type="button"
        class="whole"
        aria-label="Select ${part.name}, ${placed} of ${part.count}"
        aria-pressed=${isSelected}
        @click=${(event: MouseEvent) => this.select(part, event.ctrlKey || event.metaKey)}
      ></button>
      ${shot}
      <div class="cut ${isSelected ? "b" : ""}" title=${part.name}>${part.name}</div>
      <span class="dim row">
        ${lockMark(session, this.tray, part.index, placed)}
        ${placed === part.count || this.tray > 0 ? count(placed) : `${count(placed)} / ${count(part.count)}`}
        ${partMenu(session, this.tray, part, placed)}
        <button
          type="button"
          class="btn s ghost icon eye ${hidden ? "off" : ""}"
          aria-label=${hide}
          title=${hide}
          aria-pressed=${hidden}
          @click=${() => session.build.set(toggledPart(session.build.value, part.index))}
        >
          ${icon(hidden ? "eyeOff" : "eye")}
        </button>
      </span>
    </div>`;
  }

  private select(part: BuildPart, add: boolean): void {
    const { packing } = this.session.run.state.value;
    const { build } = this.session;
    const tray = packing?.trays[this.tray - 1];
    const own: CopyKey[] = (tray?.placements ?? [])
      .filter((placement) => placement.part === part.index)
      .map(({ part: index, copy }) => ({ part: index, copy }));
    const others = build.value.selected.filter((copy) => copy.part !== part.index);
    const all = others.length < build.value.selected.length && (add || others.length === 0);
    build.set({ selected: all ? others : add ? [...others, ...own] : own });
  }
}
