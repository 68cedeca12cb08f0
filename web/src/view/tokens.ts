/// The design's colours that the views draw with. They say the same as the style sheet's tokens of these names; drawings
/// need them as numbers, and `picture()` needs them away from the page.

import type { Theme } from "./view";

export interface Tokens {
  readonly view1: string;
  readonly view2: string;
  readonly surface: string;
  readonly line: string;
  readonly text: string;
  readonly text2: string;
  readonly accent: string;
  readonly onAccent: string;
  readonly rim: string;
  readonly warnMark: string;
  readonly bad: string;
  readonly stay: string;
  readonly select: string;
  /// Edges of the tray.
  readonly edge: string;
  /// Where nothing but shadow falls.
  readonly shadow: string;
  readonly axes: { readonly x: string; readonly y: string; readonly z: string };
  readonly glass: string;
}

const light: Tokens = {
  view1: "#fbfcfd",
  view2: "#e9ecf1",
  surface: "#ffffff",
  line: "#e2e5ea",
  text: "#171b21",
  text2: "#4a5360",
  accent: "#2a5bd7",
  onAccent: "#ffffff",
  rim: "#ffffff",
  warnMark: "#e0a030",
  bad: "#d84a3c",
  stay: "#b9c0ca",
  select: "#8fb0ff",
  edge: "#5a6270",
  shadow: "#1a2233",
  axes: { x: "#b3261e", y: "#17704a", z: "#2a5bd7" },
  glass: "#7d8aa0",
};

const dark: Tokens = {
  view1: "#272e38",
  view2: "#14181e",
  surface: "#161a20",
  line: "#2a313a",
  text: "#e8ebef",
  text2: "#b3bbc6",
  accent: "#84a8ff",
  onAccent: "#0b1530",
  rim: "#ffffff",
  warnMark: "#e0a030",
  bad: "#ff938a",
  stay: "#5d6672",
  select: "#3f5fb3",
  edge: "#a4acb8",
  shadow: "#000308",
  axes: { x: "#ff938a", y: "#62cd97", z: "#84a8ff" },
  glass: "#94a5c0",
};

export function tokens(theme: Theme): Tokens {
  return theme === "dark" ? dark : light;
}
