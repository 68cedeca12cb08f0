/// Meshes to look at and small pictures of them, each loaded once it is asked for.

import { api } from "../../api/client";
import type { Detail, Mesh } from "../../api/types";
import type { MeshData, Theme } from "../../view/view";
import { Store } from "./store";
import { bundles, pictures } from "./views";

const bundleSize = 64;
const pictureBatch = 16;
const pictureSize = 96;
/// ms that pictures wait at most for what is more urgent.
const longestHold = 5000;

/// What a mesh is, whatever its place in the list: a file that was replaced is another one.
function signature(mesh: Mesh): string {
  return `${mesh.file}#${mesh.object ?? ""}:${mesh.triangles}:${mesh.volume}:${mesh.size.join(",")}`;
}

/// Those that are loaded for many copies at once.
export type Loaded = Exclude<Detail, "fine">;

interface Wish {
  readonly mesh: Mesh;
  readonly colour: string;
  readonly theme: Theme;
}

export class MeshStore {
  /// Changes whenever there is more to see.
  readonly state = new Store<{ version: number }>({ version: 0 });
  private readonly loaded = { rough: new Map<string, MeshData>(), coarse: new Map<string, MeshData>() };
  private readonly asked = { rough: new Map<string, Promise<void>>(), coarse: new Map<string, Promise<void>>() };
  private readonly finer = new Map<string, Promise<MeshData | null>>();
  private readonly drawn = new Map<string, string>();
  private readonly latest = new Map<string, string>();
  private readonly wishes = new Map<string, Wish>();
  private drawing = false;
  private readonly holds = new Set<Promise<void>>();

  constructor(private readonly job: string) {}

  /// The finest that is loaded; `detail`: that one or none.
  mesh(mesh: Mesh, detail?: Loaded): MeshData | null {
    const key = signature(mesh);
    const { rough, coarse } = this.loaded;
    return (detail ? this.loaded[detail].get(key) : (coarse.get(key) ?? rough.get(key))) ?? null;
  }

  /// All of these, in the order asked for; who asks twice waits for the first.
  async load(meshes: readonly Mesh[], detail: Loaded = "coarse"): Promise<void> {
    const asked = this.asked[detail];
    const distinct = new Map(meshes.map((mesh) => [signature(mesh), mesh]));
    const missing = [...distinct].filter(([key]) => !asked.has(key)).map(([, mesh]) => mesh);
    for (let i = 0; i < missing.length; i += bundleSize) this.fetch(missing.slice(i, i + bundleSize), detail);
    await Promise.allSettled([...distinct.keys()].map((key) => asked.get(key)));
  }

  /// Fine enough to fill the window with.
  fine(mesh: Mesh): Promise<MeshData | null> {
    const key = signature(mesh);
    let wish = this.finer.get(key);
    if (!wish) {
      wish = this.bundle("fine", [mesh.id]).then(
        (data) => data[0] ?? null,
        () => {
          this.finer.delete(key);
          return null;
        },
      );
      this.finer.set(key, wish);
    }
    return wish;
  }

  /// A picture's address, or null until there is one; it is drawn for the next time.
  picture(mesh: Mesh, colour: string, theme: Theme): string | null {
    const key = `${signature(mesh)}|${colour}|${theme}`;
    const there = this.drawn.get(key);
    if (there === undefined && !this.wishes.has(key)) {
      this.wishes.set(key, { mesh, colour, theme });
      void this.draw();
    }
    // Until then one of the same mesh in other colours.
    return there ?? this.latest.get(signature(mesh)) ?? null;
  }

  /// Pictures wait until the function that it returns is called: what an operator looks at comes first.
  holdPictures(): () => void {
    let release = () => {};
    const hold = new Promise<void>((resolve) => {
      release = resolve;
      setTimeout(resolve, longestHold);
    });
    this.holds.add(hold);
    void hold.then(() => this.holds.delete(hold));
    return release;
  }

  private fetch(meshes: readonly Mesh[], detail: Loaded): void {
    const asked = this.asked[detail];
    const ids = meshes.map((mesh) => mesh.id);
    const done = this.bundle(detail, ids).then((data) => {
      const byId = new Map(data.map((mesh) => [mesh.id, mesh]));
      for (const mesh of meshes) {
        const found = byId.get(mesh.id);
        if (found) this.loaded[detail].set(signature(mesh), found);
      }
      this.tell();
    });
    for (const mesh of meshes) asked.set(signature(mesh), done);
    done.catch(() => {
      for (const mesh of meshes) asked.delete(signature(mesh));
    });
  }

  private async bundle(detail: Detail, ids: readonly number[]): Promise<MeshData[]> {
    const [{ readBundle }, bytes] = await Promise.all([bundles(), api.meshes(this.job, detail, ids)]);
    return readBundle(bytes);
  }

  /// One batch after the other; what was asked for last is what is on the screen, and comes first.
  private async draw(): Promise<void> {
    if (this.drawing) return;
    this.drawing = true;
    try {
      await new Promise((resolve) => setTimeout(resolve, 30));
      while (this.wishes.size > 0) {
        await Promise.all(this.holds);
        await this.drawBatch();
      }
    } finally {
      this.drawing = false;
    }
  }

  private async drawBatch(): Promise<void> {
    const [, first] = [...this.wishes].at(-1) ?? [];
    const batch = [...this.wishes]
      .reverse()
      .filter(([, wish]) => wish.theme === first?.theme)
      .slice(0, pictureBatch);
    await this.load(batch.map(([, wish]) => wish.mesh));
    const ready = batch.flatMap(([key, { mesh, colour }]) => {
      const data = this.mesh(mesh);
      return data ? [{ key, own: signature(mesh), mesh: data, colour }] : [];
    });
    for (const [key] of batch) this.wishes.delete(key);
    if (ready.length === 0 || !first) return;
    const { thumbnails } = await pictures();
    const addresses = await thumbnails(ready, pictureSize, first.theme);
    ready.forEach(({ key, own }, i) => {
      const address = addresses[i];
      if (address === undefined) return;
      this.drawn.set(key, address);
      this.latest.set(own, address);
    });
    this.tell();
  }

  private tell(): void {
    this.state.set({ version: this.state.value.version + 1 });
  }
}
