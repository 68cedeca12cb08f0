/// The icons: outlines in a square of 16, drawn in the colour of the text. They say nothing to screen readers; what they
/// stand for is in the text or the label beside them.

import { html, svg, type TemplateResult } from "lit";

const paths = {
  add: "M8 3v10M3 8h10",
  any: "M8 2.4a5.6 5.6 0 015.3 3.8M13.6 2.8v3.4h-3.4M8 13.6a5.6 5.6 0 01-5.3-3.8M2.4 13.2V9.8h3.4",
  axes: "M4 12V4M4 12h8M4 12l4.5-4.5M4 4L2.8 5.4M4 4l1.2 1.4M12 12l-1.4-1.2M12 12l-1.4 1.2",
  bad: "M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 5v3.6M8 10.9v.1",
  box: "M8 1.8l5.6 3.1v6.2L8 14.2l-5.6-3.1V4.9zM2.4 4.9L8 8l5.6-3.1M8 8v6.2",
  braces:
    "M6 2.5c-2 0-1.5 2-1.5 3.5S3 8 3 8s1.5.5 1.5 2-.5 3.5 1.5 3.5M10 2.5c2 0 1.5 2 1.5 3.5S13 8 13 8s-1.5.5-1.5 2 .5 3.5-1.5 3.5",
  check: "M3 8.5l3.2 3L13 4.5",
  clock: "M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 4.6V8l2.4 1.6",
  close: "M4 4l8 8M12 4l-8 8",
  copy: "M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",
  down: "M4 6l4 4 4-4",
  download: "M8 2v8M4.8 6.8L8 10l3.2-3.2M2.5 10.5v3h11v-3",
  drawn: "M3.5 3.5h9v9h-9zM8 6v4M6 8h4",
  eye: "M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM8 6.2a1.8 1.8 0 110 3.6 1.8 1.8 0 010-3.6",
  eyeOff: "M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM3 13L13 3",
  file: "M4 1.8h5l3.2 3.2v9.2H4zM9 1.8V5h3.2",
  find: "M7 2.5a4.5 4.5 0 110 9 4.5 4.5 0 010-9zM10.4 10.4L14 14",
  first: "M12 3.5L6.5 8l5.5 4.5zM4 3.5v9",
  flip: "M8 2v12M5.5 5L2.5 11h3zM10.5 5l3 6h-3z",
  folder: "M1.8 4h4.4l1.5 1.6h6.5v7.6H1.8z",
  frame: "M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3",
  goBack: "M4.5 11.5l7-7M6.5 4.5h5v5",
  goBend: "M4 13V7.5a2 2 0 012-2h6.5M9.5 2.5l3 3-3 3",
  goDown: "M8 3v10M4.5 9.5L8 13l3.5-3.5",
  goFront: "M11.5 4.5l-7 7M9.5 11.5h-5v-5",
  goLeft: "M13 8H3M6.5 4.5L3 8l3.5 3.5",
  goRight: "M3 8h10M9.5 4.5L13 8l-3.5 3.5",
  goUp: "M8 13V3M4.5 6.5L8 3l3.5 3.5",
  help: "M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM6.2 6.4a1.9 1.9 0 113 1.5c-.8.5-1.2.8-1.2 1.6M8 11.4v.1",
  improve: "M2.5 12.5l4-4 2.5 2.5 4.5-5.5M10 5.5h3.5V9",
  info: "M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 7.4v3.6M8 5.1v.1",
  last: "M4 3.5L9.5 8 4 12.5zM12 3.5v9",
  left: "M10 4L6 8l4 4",
  list: "M5.5 4h8M5.5 8h8M5.5 12h8M2.6 4h.1M2.6 8h.1M2.6 12h.1",
  lock: "M4 7h8v6.5H4zM5.6 7V5a2.4 2.4 0 014.8 0v2",
  mesh: "M6.5 9.5l3-3M7 4.5l1-1a2.8 2.8 0 014 4l-1 1M9 11.5l-1 1a2.8 2.8 0 01-4-4l1-1",
  minus: "M3.5 8h9",
  moon: "M13 9.6A5.6 5.6 0 016.4 3 5.6 5.6 0 1013 9.6z",
  more: "M3.5 8h.1M8 8h.1M12.5 8h.1",
  move: "M8 2v12M2 8h12M6.2 3.8L8 2l1.8 1.8M6.2 12.2L8 14l1.8-1.8M3.8 6.2L2 8l1.8 1.8M12.2 6.2L14 8l-1.8 1.8",
  pause: "M4.5 3h2.5v10H4.5zM9 3h2.5v10H9z",
  picture: "M2.5 3h11v10h-11zM2.5 11l3.2-3.2 2.6 2.6 2.2-2.2 3 3M10.5 6h.1",
  play: "M4.5 2.5L13 8l-8.5 5.5z",
  printer: "M4.5 6V2.5h7V6M4.5 11.5h-2V6h11v5.5h-2M4.5 9.5h7v4h-7z",
  redo: "M10 4l3 3-3 3M13 7H6.5a3.5 3.5 0 000 7H8",
  right: "M6 4l4 4-4 4",
  settings: "M2.5 4.5h6M11.5 4.5h2M10 3v3M2.5 11.5h2M7.5 11.5h6M6 10v3",
  stepBack: "M11 3.5L5.5 8 11 12.5z",
  stepOn: "M5 3.5L10.5 8 5 12.5z",
  stop: "M4 4h8v8H4z",
  sun: "M8 5.2a2.8 2.8 0 110 5.6 2.8 2.8 0 010-5.6M8 1.6v1.2M8 13.2v1.2M1.6 8h1.2M13.2 8h1.2M3.5 3.5l.8.8M11.7 11.7l.8.8M12.5 3.5l-.8.8M4.3 11.7l-.8.8",
  system: "M2.5 3h11v7.5h-11zM6 13.5h4M8 10.5v3",
  trash: "M3 4.4h10M6.4 4.4V2.8h3.2v1.6M4.4 4.4l.5 9.2h6.2l.5-9.2",
  unlock: "M4 7h8v6.5H4zM5.6 7V5a2.4 2.4 0 014.7-.7",
  undo: "M6 4L3 7l3 3M3 7h6.5a3.5 3.5 0 010 7H8",
  upright: "M8 13V3M8 3L5.6 5.4M8 3l2.4 2.4M3.4 13.4h9.2",
  warn: "M8 2.2L14.5 13.5h-13zM8 6.5v3.2M8 11.6v.1",
} as const;

export type IconName = keyof typeof paths;

export function icon(name: IconName): TemplateResult {
  return html`<svg class="i" viewBox="0 0 16 16" aria-hidden="true">${svg`<path d=${paths[name]} />`}</svg>`;
}

export const spinner = html`<svg class="i spin" viewBox="0 0 16 16" aria-hidden="true">
  <path d="M8 1.8a6.2 6.2 0 016.2 6.2" />
</svg>`;

export const mark = html`<svg class="mark" viewBox="0 0 20 20" aria-hidden="true">
  <path class="edge" d="M10 1.5l7.5 4.2v8.6L10 18.5l-7.5-4.2V5.7z" />
  <path class="face" d="M10 10l7.5-4.3v8.6L10 18.5z" />
  <path class="edge" d="M2.5 5.7L10 10v8.5" />
</svg>`;
