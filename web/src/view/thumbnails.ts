/// Small pictures of parts, on nothing. One renderer draws them all and is let go of once none was asked for some time;
/// the page gets its time in between.

import { Matrix4, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { type Box, identity, toTransform } from "./affine";
import { basisOf, depthRange, framed, homeAzimuth, homeElevation, lensView } from "./camera";
import { rgbOfHex } from "./colour";
import { Compose, outlineInputs } from "./compose";
import { frustumOf } from "./lists";
import { Pieces } from "./pieces";
import { Sun } from "./sun";
import { setLights } from "./uniforms";
import type { MeshData, Theme } from "./view";

export interface ThumbnailPart {
  readonly mesh: MeshData;
  /// `#rrggbb`
  readonly colour: string;
}

/// ms at a stretch; a page that gets the rest of a frame's 16 ms stays fluid.
const stretch = 9;
const share = 0.94;
const shadowMap = 256;

/// ms that the renderer is kept for the next call.
const keepTime = 4000;

let last: Promise<unknown> = Promise.resolve();
let kept: Studio | null = null;
let closing: ReturnType<typeof setTimeout> | undefined;

/// PNG pictures as data URLs, `size` pixels wide and high, in the order of `meshes`. A part that could not be drawn has
/// an empty string. Several calls are done one after the other.
export function thumbnails(meshes: readonly ThumbnailPart[], size: number, theme: Theme): Promise<string[]> {
  const result = last.then(() => drawAll(meshes, size, theme));
  last = result.catch(() => {});
  return result;
}

async function drawAll(meshes: readonly ThumbnailPart[], size: number, theme: Theme): Promise<string[]> {
  const urls: string[] = meshes.map(() => "");
  if (meshes.length === 0) return urls;
  clearTimeout(closing);
  // Where a page has many views, the browser takes the oldest one's graphics away.
  if (kept?.isLost) kept = kept.dispose();
  kept ??= Studio.open();
  if (!kept) return urls;
  kept.setUp(size, theme);
  try {
    let since = performance.now();
    for (const [i, { mesh, colour }] of meshes.entries()) {
      urls[i] = kept.draw(mesh, colour);
      if (performance.now() - since < stretch) continue;
      await new Promise((resolve) => setTimeout(resolve));
      since = performance.now();
    }
  } finally {
    closing = setTimeout(() => {
      kept = kept?.dispose() ?? null;
    }, keepTime);
  }
  return urls;
}

class Studio {
  private readonly inputs = outlineInputs();
  private readonly pieces = new Pieces(this.inputs);
  private readonly compose = new Compose(this.inputs);
  private readonly sun = new Sun(this.pieces.shared, shadowMap);
  private readonly camera = new PerspectiveCamera();
  private readonly scene = new Scene();
  private size = 0;

  private constructor(private readonly renderer: WebGLRenderer) {
    renderer.setClearColor(0x000000, 0);
    renderer.sortObjects = false;
    renderer.setPixelRatio(1);
    this.camera.matrixAutoUpdate = false;
    this.scene.matrixWorldAutoUpdate = false;
    this.scene.add(this.pieces.passes.picture);
  }

  /// Null where the page cannot draw in 3D.
  static open(): Studio | null {
    try {
      const canvas = document.createElement("canvas");
      const renderer = new WebGLRenderer({ canvas, alpha: true, antialias: false, depth: false, stencil: false });
      return new Studio(renderer);
    } catch {
      return null;
    }
  }

  setUp(size: number, theme: Theme): void {
    setLights(this.pieces.shared, theme);
    if (size === this.size) return;
    this.size = size;
    this.compose.release();
    this.renderer.setSize(size, size, false);
  }

  draw(mesh: MeshData, colour: string): string {
    if (mesh.indices.length === 0) return "";
    const { pieces, camera } = this;
    const rgb = rgbOfHex(colour);
    pieces.looks.paint = () => rgb;
    pieces.setParts([{ index: 0, name: "", mesh }]);
    pieces.place([{ part: 0, copy: 0, order: 0, transform: toTransform(identity) }], false, 0);
    pieces.looksChanged(true);
    const box = pieces.bounds() as Box;
    const lens = { view: lensView, aspect: 1 };
    const orbit = framed(
      { target: [0, 0, 0], distance: 1, azimuth: homeAzimuth, elevation: homeElevation },
      lens,
      box,
      share,
    );
    const { right, up, back, eye } = basisOf(orbit);
    camera.matrix.makeBasis(new Vector3(...right), new Vector3(...up), new Vector3(...back)).setPosition(...eye);
    camera.fov = (lens.view * 180) / Math.PI;
    const { near, far } = depthRange(orbit, box);
    camera.near = near;
    camera.far = far;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
    pieces.shared.eye.value.set(...eye);
    const all = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    pieces.update(0, frustumOf(all.elements), eye);
    pieces.prepareShadows(false);
    pieces.useShadowList(true);
    this.sun.render(this.renderer, pieces.passes.shadows, box, false);
    pieces.useShadowList(false);
    const side = Math.max(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
    const frame = { width: this.size, height: this.size, samples: 4 };
    this.compose.render(this.renderer, this.scene, null, camera, frame, 1, 0.03 * side);
    // Read before the browser takes the picture away, which it does once this script lets it.
    return this.renderer.domElement.toDataURL("image/png");
  }

  get isLost(): boolean {
    return this.renderer.getContext().isContextLost();
  }

  dispose(): null {
    this.pieces.dispose();
    this.sun.dispose();
    this.compose.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    return null;
  }
}
