/// Files that were chosen or dropped, also whole folders.

import type { PickedFile } from "../state/file_names";

export function ofInput(input: HTMLInputElement): PickedFile[] {
  const files = [...(input.files ?? [])].map((file) => ({ file, path: file.webkitRelativePath || file.name }));
  input.value = "";
  return files;
}

/// How many things are dragged, as far as the browser tells before they are dropped.
export function dragged(event: DragEvent): number {
  return [...(event.dataTransfer?.items ?? [])].filter((item) => item.kind === "file").length;
}

/// The entries have to be asked for before anything is awaited: the browser forgets them after the event.
export async function ofDrop(event: DragEvent): Promise<PickedFile[]> {
  const items = [...(event.dataTransfer?.items ?? [])].filter((item) => item.kind === "file");
  const entries = items.map((item) => item.webkitGetAsEntry?.() ?? null);
  const loose = items.map((item) => item.getAsFile());
  const found = await Promise.all(
    entries.map((entry, i) => {
      const file = loose[i];
      return entry ? filesUnder(entry) : Promise.resolve(file ? [{ file, path: file.name }] : []);
    }),
  );
  return found.flat();
}

async function filesUnder(entry: FileSystemEntry): Promise<PickedFile[]> {
  const path = entry.fullPath.replace(/^\//, "");
  if (entry.isFile) {
    const file = await new Promise<File | null>((resolve) =>
      (entry as FileSystemFileEntry).file(resolve, () => resolve(null)),
    );
    return file ? [{ file, path }] : [];
  }
  const found: PickedFile[] = [];
  for (const child of await children(entry as FileSystemDirectoryEntry)) found.push(...(await filesUnder(child)));
  return found;
}

/// A reader gives them in batches, until one is empty.
async function children(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const batch = await new Promise<FileSystemEntry[]>((resolve) => reader.readEntries(resolve, () => resolve([])));
    if (batch.length === 0) return all;
    all.push(...batch);
  }
}
