/// What the page asks of the 3D views. Lengths are mm, z is up, the tray's lower corner is the origin. A transform is
/// a 4 by 4 matrix by rows, as in packing files: from the mesh file's own coordinates to the tray's.

export type Transform = readonly (readonly number[])[];
export type Size = readonly [number, number, number];
export type Axis = "x" | "y" | "z";
export type Theme = "light" | "dark";
/// How fast something is drawn: slowly is well enough for a picture at rest.
export type Speed = "fast" | "slowly" | "never";
export type Colouring = "part" | "order" | "height" | "way";

/// A mesh to look at, as a bundle has it (`readBundle` in bundle.ts).
export interface MeshData {
  readonly id: number;
  /// 3 n, in the mesh file's own coordinates.
  readonly positions: Float32Array;
  /// 3 m
  readonly indices: Uint32Array;
}

/// A part of a packing: what its copies look like. `index` is the part's index in the packing file.
export interface ViewPart {
  readonly index: number;
  readonly name: string;
  readonly mesh: MeshData;
}

export interface CopyKey {
  readonly part: number;
  readonly copy: number;
}

export interface ViewCopy extends CopyKey {
  readonly transform: Transform;
  /// When it was placed, from 0 on; the way out's step it leaves at, where that is known.
  readonly order: number;
  readonly step?: number;
}

export interface Section {
  readonly axis: Axis;
  /// mm; what lies above it (flipped: below) is cut away.
  readonly at: number;
  readonly flipped: boolean;
}

export interface TrayViewEvents {
  /// A click on a copy, or beside all (null). `add`: with Ctrl or Cmd.
  select(copy: CopyKey | null, add: boolean): void;
  // A double click on a copy frames it, beside all the whole tray.

  /// The pointer is over a copy, or over none.
  hover?(copy: CopyKey | null): void;
  /// The handle of the section was dragged.
  section?(at: number): void;
  /// A copy with move handles (`setMoving`) is dragged: mm along the axes since the drag began. The view does not move
  /// it: place it anew. `ended`: the handle was let go, or an arrow key moved it once.
  move?(by: Size, ended: boolean): void;
  /// The graphics card took the drawing away, or gave it back.
  lost?(lost: boolean): void;
  /// Copies are in the picture for the first time.
  shown?(): void;
  /// It was measured anew how fast the machine draws (`draws`).
  paced?(): void;
}

/// A word beside a copy.
export interface Label {
  readonly copy: CopyKey;
  readonly text: string;
  /// To the right of the copy, where it does not cover the way up; without: above it.
  readonly beside?: boolean;
}

/// A side to look from.
export type Side = "home" | "front" | "back" | "left" | "right" | "top" | "bottom";

/// A tray and what stands in it. All changes are drawn with the next frame; nothing is drawn while nothing changes.
export interface TrayView {
  readonly element: HTMLElement;
  setTheme(theme: Theme): void;
  /// `height` null: without a ceiling. `container` and `keepOut` are drawn as glass: a container stands in its own box,
  /// whose lower corner is the origin; a keep-out is given by two opposite corners.
  setTray(size: readonly [number, number, number | null], container?: MeshData, keepOut?: readonly Size[][]): void;
  /// Replaces all parts; copies stand again once they are placed again.
  setParts(parts: readonly ViewPart[]): void;
  /// Better meshes for some parts. `keep`: what was drawn before is still drawn while the picture moves.
  refine(meshes: ReadonlyMap<number, MeshData>, keep?: boolean): void;
  /// How fast so many triangles are drawn, as far as is known.
  draws(triangles: number): Speed;
  clear(): void;
  /// Places copies, or moves those that stand. `landing`: fades in, and the last one keeps an outline until the next
  /// lands; none at all takes it away.
  place(copies: readonly ViewCopy[], landing?: boolean): void;
  remove(copies: readonly CopyKey[]): void;
  setColouring(colouring: Colouring): void;
  /// What a legend shows of the colouring: colours from least to greatest, and three numbers; null for parts.
  legend(): { readonly colours: readonly string[]; readonly values: readonly number[] } | null;
  setSection(section: Section | null): void;
  setSelected(copies: readonly CopyKey[]): void;
  /// Copies that are not drawn, by part or one by one.
  setHidden(hidden: (copy: CopyKey) => boolean): void;
  /// Drawn with the outline of the mark (warn-mark; `bad`: too close), and all others pale: the player's blockers.
  setMarked(copies: readonly CopyKey[], othersPale: boolean, mark?: "warn" | "bad"): void;
  /// Drawn with a quiet outline: copies that stay where they are when the rest is packed again.
  setLocked(copies: readonly CopyKey[]): void;
  /// Drawn in the accent: what leaves now, or is moved by hand. Selected copies are a lighter blue meanwhile. `ownColour`:
  /// in their part's colour and with an outline instead.
  setLeaving(copies: readonly CopyKey[], ownColour?: boolean): void;
  /// Copies drawn faint, as those that left; they cannot be clicked. Null: none.
  setFaint(faint: ((copy: CopyKey) => boolean) | null): void;
  /// Words beside copies, as the selected copy's name.
  setLabels(labels: readonly Label[]): void;
  /// Handles along the axes at a copy, to move it by hand (`events.move`). Null: none.
  setMoving(copy: CopyKey | null): void;
  /// The camera goes along with copies that move. Null: it stays.
  setFollowed(copies: readonly CopyKey[] | null): void;
  /// A path in the tray, drawn as a line with an arrow: where a copy goes. Null removes it.
  setPath(points: readonly Size[] | null): void;
  /// A box that is in the picture, too, when all is framed. Null: only the tray.
  setSurround(corners: readonly [Size, Size] | null): void;
  frame(copies: readonly CopyKey[] | null): void;
  /// Turns the camera to a side; what it looks at stays.
  look(side: Side): void;
  /// The colour of a part as `#rrggbb`.
  colourOf(part: number): string;
  picture(width: number, height: number): Promise<Blob>;
  /// The next frame is drawn whether or not anything changed; for tests and measurements.
  drawNow(): void;
  readonly statistics: { readonly copies: number; readonly triangles: number; readonly drawCalls: number };
  dispose(): void;
}

/// One part on a turntable with its box and the lengths of its sides.
export interface PartView {
  readonly element: HTMLElement;
  setTheme(theme: Theme): void;
  /// `scale`: mm a unit of the mesh. `colour` as `#rrggbb`. `stands`: ghost previews of what the part may do.
  show(mesh: MeshData | null, scale: number, colour: string, stands: "any" | "upright" | "fixed" | "axes"): void;
  dispose(): void;
}
