/// Where the server is: on this computer, or somewhere in the network.

export function isLocal(host: string): boolean {
  return host === "localhost" || host === "[::1]" || /^127\./.test(host);
}

export function filesStay(host: string): string {
  return isLocal(host) ? "Files stay on this computer." : `Files go to ${host}, and nowhere else.`;
}

export const onThere = (host: string): string => (isLocal(host) ? "on this computer" : `on ${host}`);
