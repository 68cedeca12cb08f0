/// The program's sentences, as the page says them: options by their names, a capital, a stop.

/// Help and messages name options as on the command line: --time-limit becomes “time limit”.
export function plain(text: string): string {
  return text
    .replace(/--([a-z][a-z-]*[a-z])/g, (_, name: string) => `“${name.replaceAll("-", " ")}”`)
    .replace(/(^|[\s(])'([^']+)'(?=$|[\s.,:;)])/g, "$1“$2”")
    .replaceAll("'", "’");
}

export function sentence(text: string): string {
  const own = plain(text.trim());
  const start = own.charAt(0).toUpperCase() + own.slice(1);
  return /[.!?…]$/.test(start) ? start : `${start}.`;
}
