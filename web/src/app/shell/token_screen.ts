/// Asks for the token, where the server wants one and the address did not hold it.

import { html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { ApiError } from "../../api/client";
import { exchangeToken } from "../../api/session_token";
import { mark } from "../common/icons";
import { Piece } from "../common/piece";
import { app, messageOf } from "../state/app_state";

@customElement("sp-token")
export class TokenScreen extends Piece {
  @state() private problem = "";
  @state() private busy = false;
  @query("input") private readonly input!: HTMLInputElement;

  protected override firstUpdated(): void {
    this.input.focus();
  }

  override render() {
    return html`<main class="token">
      <form class="card" @submit=${this.send}>
        <span class="brand">${mark} spectralpack</span>
        <h1>Token</h1>
        <p class="dim">This server asks for the token that it printed when it was started.</p>
        <label class="in wide ${this.problem ? "wrong" : ""}">
          <input
            type="password"
            aria-label="Token"
            aria-invalid=${this.problem !== ""}
            autocomplete="current-password"
            @input=${() => {
              this.problem = "";
            }}
          />
        </label>
        ${this.problem ? html`<p class="small bad-text" role="alert">${this.problem}</p>` : nothing}
        <button class="btn primary l" ?disabled=${this.busy}>Go on</button>
      </form>
    </main>`;
  }

  private async send(event: Event): Promise<void> {
    event.preventDefault();
    if (this.input.value.trim() === "") return;
    this.busy = true;
    try {
      await exchangeToken(this.input.value);
      app.set({ tokenWanted: false, problem: null });
    } catch (error) {
      const wrong = error instanceof ApiError && error.status === 401;
      this.problem = wrong ? "This is not the token. Look where the server was started." : messageOf(error);
    } finally {
      this.busy = false;
    }
  }
}
