/// Where a tray is cut.

import type { Axis, Section } from "../../view/view";
import type { Session } from "../state/session";

const place: Readonly<Record<Axis, 0 | 1 | 2>> = { x: 0, y: 1, z: 2 };

/// The tray's length along an axis; of a tray without a ceiling, how high it became.
export function sectionEnd(session: Session, axis: Axis): number {
  const { packing } = session.run.state.value;
  return packing?.size[place[axis]] ?? 0;
}

/// A cut starts in the middle of what stands, or where it was along this axis.
export function newSection(session: Session, axis: Axis, before: Section | null): Section {
  if (before?.axis === axis) return before;
  const { packing } = session.run.state.value;
  const tray = packing?.trays[session.build.value.tray - 1];
  const end = axis === "z" && tray ? tray.height : sectionEnd(session, axis);
  return { axis, at: Math.round(end * 5) / 10, flipped: false };
}

/// By layers; a cut along another axis moves by as much.
export function movedSection(session: Session, section: Section, layers: number): Section {
  const { packing } = session.run.state.value;
  const tray = packing?.trays[session.build.value.tray - 1];
  const step = tray?.layers?.thickness ?? 1;
  const at = Math.max(0, Math.min(sectionEnd(session, section.axis), section.at + layers * step));
  return { ...section, at: Math.round(at * 10) / 10 };
}
