/// Lines of any width, drawn as quads that face the viewer: browsers draw WebGL's own lines one pixel wide. A line may
/// narrow towards its end, which makes arrow heads, and have no length, which makes dots.

import {
  BufferAttribute,
  DoubleSide,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  ShaderMaterial,
  Sphere,
  Vector2,
} from "three";
import { premultiplied } from "./materials";
import type { Size } from "./view";

export interface Line {
  readonly from: Size;
  readonly to: Size;
  readonly colour: string;
  /// CSS pixels at both ends.
  readonly width: number;
  readonly endWidth?: number;
  /// At both ends.
  readonly opacity?: number;
  readonly endOpacity?: number;
  /// Length of a dash and of the room behind it, in CSS pixels; without: unbroken.
  readonly dash?: number;
}

const vertexShader = /* glsl */ `
in vec3 from;
in vec3 to;
in vec4 style; // widths, dash, opacity
in vec4 tint; // colour, opacity at the end
uniform vec2 screen; // pixels
uniform float ratio; // device pixels a CSS pixel
out vec4 vColour;
out vec2 vPlace; // pixels from the first end, and across
out vec3 vShape; // half widths, length
out float vDash;

void main() {
  mat4 m = projectionMatrix * viewMatrix;
  vec4 a = m * vec4(from, 1.0);
  vec4 b = m * vec4(to, 1.0);
  // An end behind the eye is drawn in to just before it.
  float least = 1e-3;
  if (a.w < least && b.w < least) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < least) a = mix(b, a, (b.w - least) / (b.w - a.w));
  if (b.w < least) b = mix(a, b, (a.w - least) / (a.w - b.w));
  vec2 pa = a.xy / a.w * screen * 0.5;
  vec2 pb = b.xy / b.w * screen * 0.5;
  vec2 way = pb - pa;
  float length_ = length(way);
  vec2 d = length_ > 1e-4 ? way / length_ : vec2(1.0, 0.0);
  vec2 n = vec2(-d.y, d.x);
  vec2 half_ = 0.5 * style.xy * ratio;
  float reach = max(half_.x, half_.y) + 1.0;
  bool end = position.x > 0.5;
  float t = end ? length_ + reach : -reach;
  vec2 p = pa + d * t + n * position.y * reach;
  vec4 at = end ? b : a;
  // A hair nearer than the faces that it lies on.
  at.z -= 2e-5 * at.w;
  gl_Position = vec4(p / (screen * 0.5) * at.w, at.z, at.w);
  vPlace = vec2(t, position.y * reach);
  vShape = vec3(half_, length_);
  vDash = style.z * ratio;
  float opacity = end ? tint.a : style.w;
  vColour = vec4(tint.rgb, opacity);
}
`;

const fragmentShader = /* glsl */ `
in vec4 vColour;
in vec2 vPlace;
in vec3 vShape;
in float vDash;
out vec4 colour;

void main() {
  float t = clamp(vPlace.x / max(vShape.z, 1e-3), 0.0, 1.0);
  float radius = mix(vShape.x, vShape.y, t);
  // Ends are round where the line keeps its width; an arrow head's are not.
  float beyond = max(-vPlace.x, vPlace.x - vShape.z);
  float away = length(vec2(max(0.0, beyond), vPlace.y)) - radius;
  if (abs(vShape.x - vShape.y) > 0.5) away = max(abs(vPlace.y) - radius, beyond);
  float cover = clamp(0.5 - away, 0.0, 1.0);
  if (vDash > 0.0) {
    float place = mod(vPlace.x, 2.0 * vDash);
    cover *= clamp(min(place, 1.2 * vDash - place) + 0.5, 0.0, 1.0);
  }
  float alpha = cover * vColour.a;
  if (alpha < 0.002) discard;
  colour = vec4(vColour.rgb * alpha, alpha);
}
`;

/// Numbers a line: from, to, style.
const stride = 10;

export class Lines {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private capacity = 0;

  constructor(depthTest: boolean) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { screen: { value: new Vector2(1, 1) }, ratio: { value: 1 } },
      ...premultiplied,
      side: DoubleSide,
      depthTest,
      depthWrite: false,
    });
    this.mesh = new Mesh(this.geometryFor(8), material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  set(lines: readonly Line[]): void {
    if (lines.length > this.capacity) {
      this.mesh.geometry.dispose();
      this.mesh.geometry = this.geometryFor(2 * lines.length);
    }
    const { geometry } = this.mesh;
    const shape = (geometry.getAttribute("from") as InterleavedBufferAttribute).data;
    const tint = geometry.getAttribute("tint") as InstancedBufferAttribute;
    lines.forEach((line, i) => {
      const { from, to, colour, width, endWidth = width, opacity = 1, endOpacity = opacity, dash = 0 } = line;
      shape.array.set([...from, ...to, width, endWidth, dash, opacity], stride * i);
      // Lines are drawn over a picture that is encoded already.
      const byte = (at: number) => Number.parseInt(colour.slice(at, at + 2), 16) / 255;
      tint.array.set([byte(1), byte(3), byte(5), endOpacity], 4 * i);
    });
    shape.needsUpdate = true;
    tint.needsUpdate = true;
    geometry.instanceCount = lines.length;
    this.mesh.visible = lines.length > 0;
  }

  /// Size of the drawing in device pixels, and how many of them make a CSS pixel.
  setScreen(width: number, height: number, ratio: number): void {
    const { screen, ratio: r } = this.mesh.material.uniforms as {
      screen: { value: Vector2 };
      ratio: { value: number };
    };
    screen.value.set(width, height);
    r.value = ratio;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private geometryFor(capacity: number): InstancedBufferGeometry {
    this.capacity = capacity;
    const geometry = new InstancedBufferGeometry();
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const shape = new InstancedInterleavedBuffer(new Float32Array(stride * capacity), stride);
    geometry.setAttribute("from", new InterleavedBufferAttribute(shape, 3, 0));
    geometry.setAttribute("to", new InterleavedBufferAttribute(shape, 3, 3));
    geometry.setAttribute("style", new InterleavedBufferAttribute(shape, 4, 6));
    geometry.setAttribute("tint", new InstancedBufferAttribute(new Float32Array(4 * capacity), 4));
    geometry.boundingSphere = new Sphere();
    return geometry;
  }
}
