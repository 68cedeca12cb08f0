/// The token that a server on a network asks for. It comes in the address's fragment, which browsers send to nobody, and
/// is taken out of the address bar and its history before anything else happens.

import { api } from "./client";

/// The token in the fragment, or null; the fragment is then empty.
export function takeToken(location: Location, history: History): string | null {
  const match = /^#token=(.+)$/.exec(location.hash);
  if (!match?.[1]) return null;
  history.replaceState(null, "", location.pathname + location.search);
  return decodeURIComponent(match[1]);
}

export async function exchangeToken(token: string): Promise<void> {
  await api.startSession(token.trim());
}
