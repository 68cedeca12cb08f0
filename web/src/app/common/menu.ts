/// A button that opens a menu below it, or above where there is no room below. Arrow keys go through its entries; Escape, a
/// click elsewhere, scrolling and leaving it close it. The entries are whatever has the role menuitem.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { Piece } from "./piece";

@customElement("sp-menu")
export class Menu extends Piece {
  @property({ attribute: false }) button: TemplateResult | string = "";
  @property({ attribute: false }) content: () => TemplateResult = () => html``;
  @property() label = "";
  @property() buttonClasses = "btn";
  @property() menuClasses = "";
  @property({ type: Boolean }) disabled = false;
  @property() hint = "";
  @state() private open = false;

  private readonly outside = (event: Event) => {
    if (!this.contains(event.target as Node)) this.close(false);
  };

  private readonly moved = (event: Event) => {
    const menu = this.querySelector(".menu");
    if (!(event.target instanceof Node && menu?.contains(event.target))) this.close(false);
  };

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopListening();
  }

  override render() {
    return html`<button
        type="button"
        class=${this.buttonClasses}
        aria-haspopup="menu"
        aria-expanded=${this.open}
        aria-label=${this.label || nothing}
        title=${this.hint || nothing}
        ?disabled=${this.disabled}
        @click=${() => (this.open ? this.close(true) : this.show())}
        @keydown=${(event: KeyboardEvent) => {
          if (event.key !== "ArrowDown" || this.open) return;
          event.preventDefault();
          this.show();
        }}
      >
        ${this.button}
      </button>
      ${
        this.open
          ? html`<div
              class="menu ${this.menuClasses}"
              popover="manual"
              role="menu"
              @keydown=${this.key}
              @click=${this.clicked}
              @focusout=${this.left}
            >
              ${this.content()}
            </div>`
          : nothing
      }`;
  }

  show(): void {
    if (this.disabled) return;
    this.open = true;
    document.addEventListener("pointerdown", this.outside, true);
    document.addEventListener("scroll", this.moved, true);
    addEventListener("resize", this.moved);
    void this.updateComplete.then(() => {
      this.place();
      this.items()[0]?.focus({ preventScroll: true });
    });
  }

  /// In the browser's top layer, so that no panel cuts it off.
  private place(): void {
    const menu = this.querySelector<HTMLElement>(".menu");
    const button = this.querySelector<HTMLElement>("button[aria-haspopup]")?.getBoundingClientRect();
    if (!menu || !button) return;
    menu.showPopover();
    const own = menu.getBoundingClientRect();
    const edge = 8;
    const left = button.left + own.width > innerWidth - edge ? button.right - own.width : button.left;
    const below = button.bottom + 4;
    const top = below + own.height > innerHeight - edge ? button.top - 4 - own.height : below;
    menu.style.left = `${Math.max(edge, left)}px`;
    menu.style.top = `${Math.max(edge, top)}px`;
  }

  private stopListening(): void {
    document.removeEventListener("pointerdown", this.outside, true);
    document.removeEventListener("scroll", this.moved, true);
    removeEventListener("resize", this.moved);
  }

  close(refocus: boolean): void {
    if (!this.open) return;
    this.open = false;
    this.stopListening();
    if (refocus) this.querySelector<HTMLElement>("button[aria-haspopup]")?.focus();
  }

  private items(): HTMLElement[] {
    return [...this.querySelectorAll<HTMLElement>(".menu [role^=menuitem]:not([disabled]):not([aria-disabled=true])")];
  }

  private clicked(event: Event): void {
    const item = (event.target as HTMLElement).closest("[role^=menuitem]");
    if (item && !item.hasAttribute("data-stays")) this.close(true);
  }

  private left(event: FocusEvent): void {
    if (event.relatedTarget && !this.contains(event.relatedTarget as Node)) this.close(false);
  }

  private key(event: KeyboardEvent): void {
    const items = this.items();
    const at = items.indexOf(document.activeElement as HTMLElement);
    const steps: Readonly<Record<string, number>> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1 + items.length,
      Home: 0,
      End: items.length - 1,
    };
    const to = steps[event.key];
    if (to !== undefined && items.length > 0) {
      event.preventDefault();
      event.stopPropagation();
      items[to % items.length]?.focus();
    } else if (event.key === "Escape") {
      event.stopPropagation();
      this.close(true);
    }
  }
}
