/// Where in the page one is, as the address's fragment says it: #/job/ID/build.

export type Step = "parts" | "build" | "apart";
export type Route = { readonly page: "start" } | { readonly page: "job"; readonly id: string; readonly step: Step };

export function parseRoute(hash: string): Route {
  const match = /^#\/job\/([a-z0-9]{12})(?:\/(parts|build|apart))?\/?$/.exec(hash);
  if (!match?.[1]) return { page: "start" };
  return { page: "job", id: match[1], step: (match[2] as Step | undefined) ?? "parts" };
}

export function hashOf(route: Route): string {
  return route.page === "start" ? "#/" : `#/job/${route.id}/${route.step}`;
}

export function go(route: Route, replace = false): void {
  const hash = hashOf(route);
  if (location.hash === hash) return;
  if (replace) location.replace(hash);
  else location.hash = hash;
}
