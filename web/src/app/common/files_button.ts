/// Opens the browser's choice of files, or of a folder, and hands on what was chosen.

import type { PickedFile } from "../state/file_names";
import { ofInput } from "./picked_files";

export const readableEndings = ".stl,.3mf,.obj,.ply,.off,.csv,.json";

export function chooseFiles(
  take: (files: PickedFile[]) => void,
  kind: { readonly folder?: boolean; readonly several?: boolean; readonly accept?: string } = {},
): void {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = kind.several ?? true;
  if (kind.folder) input.webkitdirectory = true;
  else input.accept = kind.accept ?? readableEndings;
  input.addEventListener("change", () => take(ofInput(input)));
  input.click();
}
