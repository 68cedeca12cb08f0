/// The page as a whole: the bar at the top, what the address names below it, and what is said over all of it.

import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import { api } from "../../api/client";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { app, tell } from "../state/app_state";
import { closeJob, open, openJob } from "../state/open_job";
import { go, type Route, type Step } from "../state/route";
import { isRunning } from "../state/runner";
import type { Session } from "../state/session";
import { listenToKeys } from "./keys";
import "./help_dialog";
import "./token_screen";
import "./toast";
import "./top_bar";
import "../apart/apart_page";
import "../build/build_page";
import "../parts/parts_page";
import "../start/start_page";

const askAgain = 3000;

@customElement("sp-app")
export class App extends Piece {
  /// The token was looked at; only then is anything asked for.
  @property({ type: Boolean }) ready = false;
  private route: Route | null = null;
  private retry = 0;
  private learning = false;

  protected override stores() {
    const session = open.value.session;
    return session ? [app, open, session.run.state] : [app, open];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    listenToKeys();
  }

  protected override updated(_changed: PropertyValues): void {
    if (!this.ready) return;
    if (app.value.tokenWanted) {
      // Whatever was asked for was refused; it is asked for anew.
      this.route = null;
      return;
    }
    if (!app.value.info) void this.learn();
    if (this.route !== app.value.route) this.follow(app.value.route);
    if (!app.value.connected) this.askSoon();
    const session = open.value.session;
    document.title = session && app.value.route.page === "job" ? `${session.job.name} · spectralpack` : "spectralpack";
  }

  private async learn(): Promise<void> {
    if (this.learning) return;
    this.learning = true;
    try {
      app.set({ info: await api.info() });
    } catch {
      // The banner says it; it is asked again.
    } finally {
      this.learning = false;
    }
  }

  private follow(route: Route): void {
    const before = this.route;
    this.route = route;
    if (route.page === "start") closeJob();
    else if (before?.page !== "job" || before.id !== route.id || !open.value.session) void openJob(route.id);
  }

  /// A server that went away is asked for until it is there again.
  private askSoon(): void {
    clearTimeout(this.retry);
    this.retry = window.setTimeout(async () => {
      try {
        app.set({ info: await api.info() });
        await open.value.session?.run.refresh();
        if (!open.value.session && this.route?.page === "job") void openJob(this.route.id);
      } catch {
        this.askSoon();
      }
    }, askAgain);
  }

  override render() {
    const { tokenWanted, dialog } = app.value;
    if (!this.ready) return nothing;
    if (tokenWanted) return html`<sp-token></sp-token>`;
    return html`<div class="app">
        <sp-top-bar></sp-top-bar>
        <div class="page">${this.banners()}${this.page()}</div>
      </div>
      <sp-toast></sp-toast>
      <div class="out" role="status" aria-live="polite">${app.value.announcement}</div>
      ${dialog === "help" ? html`<sp-help></sp-help>` : nothing}`;
  }

  private banners(): TemplateResult {
    const { connected, problem } = app.value;
    return html`${
      connected
        ? nothing
        : html`<div class="banner warn" role="alert">
            ${icon("warn")}
            <span class="grow"><b>No answer from the server.</b> Jobs that run go on; the page asks again by itself.</span>
          </div>`
    }${
      problem && connected
        ? html`<div class="banner bad" role="alert">
            ${icon("bad")}<span class="grow">${problem}</span>
            <button type="button" class="btn s" @click=${() => tell(null)}>Close</button>
          </div>`
        : nothing
    }`;
  }

  private page(): TemplateResult | typeof nothing {
    const { route } = app.value;
    if (route.page === "start") return html`<sp-start></sp-start>`;
    const { session, problem } = open.value;
    if (session && session.id === route.id) return this.jobPage(session, route.step);
    if (problem === null) return html`<main class="empty" aria-busy="true"></main>`;
    return html`<main class="empty">
      <h2>This job cannot be opened</h2>
      <p class="dim">${problem}</p>
      <button type="button" class="btn" @click=${() => go({ page: "start" })}>All jobs</button>
    </main>`;
  }

  private jobPage(session: Session, step: Step): TemplateResult {
    const something = isRunning(session.job) || session.job.status !== "new" || session.job.has_packing;
    const pages: Readonly<Record<Step, TemplateResult>> = {
      parts: html`<sp-parts .session=${session}></sp-parts>`,
      build: html`<sp-build .session=${session}></sp-build>`,
      apart: html`<sp-apart .session=${session}></sp-apart>`,
    };
    return html`${keyed(session, pages[something ? step : "parts"])}`;
  }
}
