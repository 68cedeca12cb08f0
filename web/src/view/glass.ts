/// Glass: a container's mesh and keep-out boxes, seen through and never in the way. Rims are denser than faces, so the
/// shape shows.

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  type IUniform,
  Mesh,
  ShaderMaterial,
  Sphere,
  type Vector3,
} from "three";
import { type Box, emptyBox, growByPoint } from "./affine";
import { premultiplied } from "./materials";
import { meshFacts } from "./mesh_facts";
import type { MeshData, Size } from "./view";

const vertexShader = /* glsl */ `
uniform vec3 shift;
out vec3 vWorld;
void main() {
  vWorld = position + shift;
  gl_Position = projectionMatrix * (viewMatrix * vec4(vWorld, 1.0));
}
`;

const fragmentShader = /* glsl */ `
uniform vec3 eye;
uniform vec3 tint; // as encoded
uniform vec2 density; // of faces seen square, and of rims
in vec3 vWorld;
out vec4 colour;
void main() {
  vec3 n = normalize(cross(dFdx(vWorld), dFdy(vWorld)));
  float rim = 1.0 - abs(dot(n, normalize(eye - vWorld)));
  float a = mix(density.x, density.y, rim * rim * rim);
  colour = vec4(tint * a, a);
}
`;

export class Glass {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

  constructor(eye: IUniform<Vector3>, face: number, rim: number) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: {
        eye,
        shift: { value: [0, 0, 0] },
        tint: { value: [0.5, 0.5, 0.5] },
        density: { value: [face, rim] },
      },
      ...premultiplied,
      side: DoubleSide,
      depthWrite: false,
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  setColour(hex: string): void {
    const byte = (at: number) => Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    this.set("tint", [byte(1), byte(3), byte(5)]);
  }

  /// The mesh, moved so that its box begins at the origin, as a container stands. Null: none.
  setContainer(mesh: MeshData | null): void {
    if (mesh) {
      const [x, y, z] = meshFacts(mesh).box;
      this.set("shift", [-x, -y, -z]);
    }
    this.show(mesh?.positions ?? new Float32Array(0), mesh?.indices ?? new Uint32Array(0));
  }

  setBoxes(boxes: readonly Readonly<Box>[]): void {
    this.set("shift", [0, 0, 0]);
    const faces = [
      0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7,
    ];
    const positions: number[] = [];
    const indices: number[] = [];
    for (const [x0, y0, z0, x1, y1, z1] of boxes) {
      const first = positions.length / 3;
      for (const z of [z0, z1]) positions.push(x0, y0, z, x1, y0, z, x1, y1, z, x0, y1, z);
      for (const corner of faces) indices.push(first + corner);
    }
    this.show(Float32Array.from(positions), Uint32Array.from(indices));
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private show(positions: Float32Array, indices: Uint32Array): void {
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    geometry.boundingSphere = new Sphere();
    this.mesh.geometry = geometry;
    this.mesh.visible = indices.length > 0;
  }

  private set(name: string, value: number[]): void {
    const uniform = this.mesh.material.uniforms[name];
    if (uniform) uniform.value = value;
  }
}

/// The box of two opposite corners, in whichever order they are given.
export function boxOfCorners(points: readonly Size[]): Box {
  const box = emptyBox();
  for (const [x, y, z] of points) growByPoint(box, x, y, z);
  return box;
}
