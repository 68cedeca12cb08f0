/// An empty tray, drawn as edges: what the page is about, before there is anything in it.

import { html } from "lit";

/// Corners of a box seen from above its near corner: floor and lid, anticlockwise from the near one.
const low = "250,392 20,300 142,228 354,298";
const high = "258,96 0,40 138,-2 374,38";

export const emptyTray = html`<svg class="empty-tray" viewBox="-8 -14 392 418" aria-hidden="true">
  <polygon class="floor" points=${low} />
  <path class="far" d="M142 228L138 -2" />
  <path d="M250 392L258 96M20 300L0 40M354 298L374 38" />
  <path d="M20 300L250 392L354 298" />
  <path class="far" d="M20 300L142 228L354 298" />
  <polygon points=${high} />
</svg>`;
