/// Copies in the program's sentences, by the names that the page has for them: the program counts through the whole build.

import type { Packing } from "../state/packing";

/// "41 elbow and 55 mug overlap" as "elbow 3 and mug 1 overlap".
export function namedCopies(text: string, packing: Packing | null): string {
  if (!packing) return text;
  const starts = new Map<string, { readonly first: number; readonly count: number }[]>();
  let first = 1;
  for (const { name, count } of packing.parts) {
    starts.set(name, [...(starts.get(name) ?? []), { first, count }]);
    first += count;
  }
  // The longest first: a name may begin with another.
  const names = [...starts.keys()].filter((name) => name !== "").sort((a, b) => b.length - a.length);
  if (names.length === 0) return text;
  const pattern = new RegExp(`(?<![\\w.])(\\d+) (${names.map(escaped).join("|")})(?![\\w-])`, "g");
  return text.replace(pattern, (whole, number: string, name: string) => {
    const own = starts
      .get(name)
      ?.find(({ first: from, count }) => Number(number) >= from && Number(number) < from + count);
    return own ? `${name} ${Number(number) - own.first + 1}` : whole;
  });
}

const escaped = (name: string): string => name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
