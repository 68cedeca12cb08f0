/// What a run says that is of use here: how it keeps its journal is the server's business.

import { sentence } from "./sentence";

export function news(remarks: readonly string[]): string[] {
  return remarks.filter((text) => !/journal|same command/.test(text)).map(sentence);
}
