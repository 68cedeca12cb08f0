/// The passes over the parts' copies, and the textures they read them from (see shaders.ts).

import {
  DataTexture,
  FloatType,
  Group,
  type InstancedBufferGeometry,
  Mesh,
  NearestFilter,
  RedIntegerFormat,
  RGBAFormat,
  type ShaderMaterial,
  UnsignedIntType,
} from "three";

/// Texels a row of both textures; the shaders know it, too.
const textureWidth = 1024;

/// Draws a run of the list.
class RangeMesh extends Mesh<InstancedBufferGeometry, ShaderMaterial> {
  private runs = 0;

  constructor(geometry: InstancedBufferGeometry, material: ShaderMaterial) {
    super(geometry, material);
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
    this.matrixWorldAutoUpdate = false;
    // Passes share a shape's geometry, and three.js asks it how many copies to draw.
    this.onBeforeRender = () => {
      this.geometry.instanceCount = this.runs;
    };
  }

  set(base: number, count: number): void {
    this.matrixWorld.elements[12] = base;
    this.runs = count;
    this.visible = count > 0;
  }
}

/// One pass: a mesh for each shape that has copies in it.
export class Pass {
  readonly group = new Group();
  private meshes = new Map<number, RangeMesh>();

  constructor(private readonly material: ShaderMaterial) {
    this.group.matrixWorldAutoUpdate = false;
  }

  set(shape: number, geometry: InstancedBufferGeometry, base: number, count: number): void {
    let mesh = this.meshes.get(shape);
    if (!mesh) {
      if (count === 0) return;
      mesh = new RangeMesh(geometry, this.material);
      this.meshes.set(shape, mesh);
      this.group.add(mesh);
    }
    mesh.geometry = geometry;
    mesh.set(base, count);
  }

  remove(shape: number): void {
    const mesh = this.meshes.get(shape);
    if (!mesh) return;
    this.group.remove(mesh);
    this.meshes.delete(shape);
  }

  clear(): void {
    this.group.clear();
    this.meshes.clear();
  }
}

export function listTexture(capacity: number): DataTexture {
  const height = Math.max(1, Math.ceil(capacity / textureWidth));
  const data = new Uint32Array(textureWidth * height);
  const texture = new DataTexture(data, textureWidth, height, RedIntegerFormat, UnsignedIntType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.unpackAlignment = 4;
  return texture;
}

export function copyTexture(slots: number): DataTexture {
  const height = Math.max(1, Math.ceil((4 * slots) / textureWidth));
  const data = new Float32Array(4 * textureWidth * height);
  const texture = new DataTexture(data, textureWidth, height, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  return texture;
}
