/// The view's background: brightest a little above the middle. The page draws it behind the drawing, which is seen
/// through; a picture to keep has it painted in.

import { tokens } from "./tokens";
import type { Theme } from "./view";

/// In relation to the view's width and height.
const shape = { width: 0.9, height: 0.8, x: 0.5, y: 0.42 };

export function backgroundStyle(theme: Theme): string {
  const { view1, view2 } = tokens(theme);
  const percent = (v: number) => `${100 * v}%`;
  const ellipse = `ellipse ${percent(shape.width)} ${percent(shape.height)} at ${percent(shape.x)} ${percent(shape.y)}`;
  return `radial-gradient(${ellipse}, ${view1}, ${view2})`;
}

export function paintBackground(context: CanvasRenderingContext2D, width: number, height: number, theme: Theme): void {
  const t = tokens(theme);
  context.save();
  context.translate(shape.x * width, shape.y * height);
  context.scale(shape.width * width, shape.height * height);
  const gradient = context.createRadialGradient(0, 0, 0, 0, 0, 1);
  gradient.addColorStop(0, t.view1);
  gradient.addColorStop(1, t.view2);
  context.fillStyle = gradient;
  context.fillRect(-2, -2, 4, 4);
  context.restore();
}
