/// How a value became better over time: steps from where it began, with the gain in words.

import { html, nothing, svg, type TemplateResult } from "lit";
import type { Curve } from "../state/curve";
import { gainWords, lessIsBetter, valueName, valueWords } from "../words/improve";
import { clock } from "../words/times";

const width = 272;
const height = 96;
/// Room above the best and below the worst value.
const edge = 8;
/// s; a longer time is until it is stopped.
const longest = 43_200;

export interface Plot {
  /// SVG path of the steps.
  readonly line: string;
  readonly area: string;
  /// Where the value began and where it is now, from the top.
  readonly startY: number;
  readonly nowY: number;
  readonly nowX: number;
}

/// Up is better. Null before there is anything to draw. `ends`: what time is left is not used.
export function plotOf(curve: Curve, ends = false): Plot | null {
  const [first] = curve.points;
  if (!first) return null;
  const start = first.seconds;
  const span = Math.max(1, curve.seconds - start + timeLeft(curve, ends));
  const gains = curve.points.map(({ value }) => (lessIsBetter(curve.what) ? first.value - value : value - first.value));
  const most = Math.max(...gains, Math.abs(first.value) * 1e-4, 1e-9);
  const x = (seconds: number) => ((seconds - start) / span) * width;
  const y = (gain: number) => height - edge - (Math.max(0, gain) / most) * (height - 2 * edge);
  let path = "";
  curve.points.forEach(({ seconds }, i) => {
    const level = y(gains[i] ?? 0).toFixed(1);
    path += i === 0 ? `M0 ${level}` : `H${x(seconds).toFixed(1)}V${level}`;
  });
  const nowX = x(curve.seconds);
  path += `H${nowX.toFixed(1)}`;
  return {
    line: path,
    area: `${path}V${height}H0Z`,
    startY: y(0),
    nowY: y(gains[gains.length - 1] ?? 0),
    nowX,
  };
}

/// A run without end is drawn up to now.
const timeLeft = ({ left }: Curve, ends: boolean): number =>
  ends || left === null || left > longest ? 0 : Math.max(0, left);

export function curveFigure(curve: Curve, ends = false): TemplateResult | typeof nothing {
  const plot = plotOf(curve, ends);
  if (!plot) return nothing;
  const { what, before, now } = curve;
  const [first] = curve.points;
  const start = first?.seconds ?? 0;
  const end = curve.seconds - start + timeLeft(curve, ends);
  const gain = gainWords(what, before, now);
  const words = `${valueName(what)} from ${valueWords(what, before)} to ${valueWords(what, now)} within ${clock(curve.seconds - start)}`;
  return html`<figure class="curve">
    <div class="row between small">
      <span class="dim">at first ${valueWords(what, before)}</span>
      <span class="b accent">${gain ? `best ${valueWords(what, now)}` : ""}</span>
    </div>
    <svg viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" role="img" aria-label=${words}>
      ${svg`<path class="area" d=${plot.area} />
        <path class="start" d="M0 ${plot.startY}H${width}" />
        <path class="line" d=${plot.line} />`}
    </svg>
    <div class="row between scale faint"><span>0</span><span>${end > 0 ? clock(end) : ""}</span></div>
  </figure>`;
}
