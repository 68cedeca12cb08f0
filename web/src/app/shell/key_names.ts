/// How keys are named.

/// A key press as it is written: "Ctrl+Shift+Z", "[", "Shift+[", "/". Letters are capitals.
export function nameOf(
  event: Pick<KeyboardEvent, "key" | "code" | "ctrlKey" | "metaKey" | "shiftKey" | "altKey">,
): string {
  const control = event.ctrlKey || event.metaKey ? "Ctrl+" : "";
  const alt = event.altKey ? "Alt+" : "";
  // Shift changes what a bracket's key says, and where slash and question mark are differs by keyboard.
  if (event.code === "BracketLeft" || event.code === "BracketRight") {
    if (event.key === "{" || event.key === "[") return `${control}${alt}${event.shiftKey ? "Shift+" : ""}[`;
    if (event.key === "}" || event.key === "]") return `${control}${alt}${event.shiftKey ? "Shift+" : ""}]`;
  }
  if (event.key.length === 1 && !/[a-z]/i.test(event.key)) return `${control}${alt}${event.key}`;
  const shift = event.shiftKey ? "Shift+" : "";
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  return `${control}${alt}${shift}${key === "Escape" ? "Esc" : key === "Delete" ? "Del" : key}`;
}

/// `keys`: as a set of keys writes them, with arrows and the space by what they look like; "1–9" stands for nine.
export function matches(keys: readonly string[], name: string): boolean {
  return keys.some((written) => plainName(written) === name || (written === "1–9" && /^[1-9]$/.test(name)));
}

const plainNames: Readonly<Record<string, string>> = {
  "←": "ArrowLeft",
  "→": "ArrowRight",
  "↑": "ArrowUp",
  "↓": "ArrowDown",
  Space: " ",
};

const plainName = (written: string): string => written.replace(/[←→↑↓]|Space/, (sign) => plainNames[sign] ?? sign);

/// Keys without Ctrl, which can be switched off.
export const isLetter = (name: string): boolean => /^(Shift\+)?[A-Z0-9]$|^[[\]/]$|^Shift\+[[\]]$/.test(name);
