/// Puts a frame together: the scene into a texture with its depths, the outlined copies into another, and both onto the
/// canvas. Depths that jump are darkened on their far side, which parts copies that touch and shows edges and dents.

import {
  DepthStencilFormat,
  DepthTexture,
  GLSL3,
  LinearFilter,
  Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  type PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  UnsignedInt248Type,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";
import { stencilMiddle } from "./materials";

const fullVertex = /* glsl */ `
void main() {
  gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
}
`;

const composeFragment = /* glsl */ `
uniform sampler2D scene;
uniform highp sampler2D depth;
uniform sampler2D outlines;
uniform bool hasOutlines;
uniform vec2 pixel; // of the canvas, in texture units
uniform float ratio; // device pixels a CSS pixel
uniform vec2 nearFar;
uniform float reach; // mm: depth that counts as a full step
uniform vec3 accent;
uniform vec3 mark;
uniform vec3 rim;
uniform vec2 through; // how strongly what is hidden is seen: of the accent, of the mark
out vec4 colour;

float distanceAt(vec2 at) {
  float d = texture(depth, at).r;
  return nearFar.x * nearFar.y / (nearFar.y - d * (nearFar.y - nearFar.x));
}

// How far a point lies behind the line between two opposite neighbours: above 0 in dents and behind edges, below on
// ridges. On a plane it is 0, however it slopes.
float behind(vec2 at, float own, vec2 offset) {
  float a = distanceAt(at + offset);
  float b = distanceAt(at - offset);
  return clamp((own - 0.5 * (a + b)) / reach, -0.35, 1.0);
}

vec4 line(vec2 kind, float least, float most, vec3 tint, vec4 under) {
  // In sight: the line inside the edge, the rim outside it.
  float inner = kind.x * (1.0 - least);
  float outer = (1.0 - kind.x) * most;
  vec4 c = mix(under, vec4(tint, 1.0), inner);
  return mix(c, vec4(rim, 1.0), outer * 0.95);
}

void main() {
  vec2 at = gl_FragCoord.xy * pixel;
  vec4 c = texture(scene, at);
  // Depths lie coarser than pixels while moving on a slow machine: neighbours must be other texels.
  vec2 texel = 1.0 / vec2(textureSize(depth, 0));
  vec2 there = (floor(at / texel) + 0.5) * texel;
  float own = distanceAt(there);
  if (own < nearFar.y * 0.9999) {
    vec2 p = max(pixel * ratio, texel);
    float near = behind(there, own, p * vec2(1.0, 0.0)) + behind(there, own, p * vec2(0.0, 1.0)) +
                 behind(there, own, p * vec2(1.0, 1.0)) + behind(there, own, p * vec2(1.0, -1.0));
    float wide = behind(there, own, p * vec2(4.0, 1.5)) + behind(there, own, p * vec2(-1.5, 4.0)) +
                 behind(there, own, p * vec2(2.0, 2.5)) + behind(there, own, p * vec2(-2.5, 2.0));
    float s = near * 0.25;
    // Small steps are the facets of round faces, which are to look round.
    float dent = max(s - 0.015, 0.0);
    float halo = max(wide * 0.25 - 0.03, 0.0);
    float ridge = min(s + 0.1, 0.0);
    c.rgb *= exp(-0.64 * dent - 0.42 * halo) * (1.0 - 0.22 * ridge);
    c.rgb = min(c.rgb, vec3(c.a));
  }
  if (hasOutlines) {
    vec4 inside = texture(outlines, at);
    vec4 least = inside;
    vec4 most = inside;
    vec4 hiddenLeast = inside;
    for (int i = 0; i < 12; ++i) {
      float angle = float(i) * 0.5235988;
      vec2 away = vec2(cos(angle), sin(angle)) * pixel * ratio;
      vec4 t = texture(outlines, at + away * 1.9);
      least = min(least, t);
      most = max(most, t);
      hiddenLeast = min(hiddenLeast, texture(outlines, at + away * 1.1));
    }
    // What is hidden: a faint tint and a thin line, so that a copy deep in the tray can be found.
    vec2 covered = inside.yw * (1.0 - inside.xz);
    vec2 thin = covered * (1.0 - hiddenLeast.yw);
    vec2 seen = covered * through + thin * 0.5 * step(0.001, through);
    c = mix(c, vec4(accent, 1.0), min(seen.x, 1.0));
    c = mix(c, vec4(mark, 1.0), min(seen.y, 1.0));
    c = line(inside.zw, least.z, most.z, mark, c);
    c = line(inside.xy, least.x, most.x, accent, c);
  }
  colour = c;
}
`;

interface Targets {
  readonly scene: WebGLRenderTarget;
  outlines: WebGLRenderTarget | null;
}

export interface OutlineInputs {
  readonly [name: string]: { value: unknown };
  readonly sceneDepth: { value: DepthTexture | null };
  readonly nearFar: { value: Vector2 };
}

export function outlineInputs(): OutlineInputs {
  return { sceneDepth: { value: null }, nearFar: { value: new Vector2(1, 2) } };
}

export interface FrameSize {
  /// Device pixels of what is drawn; less than the canvas has while moving on a slow machine.
  readonly width: number;
  readonly height: number;
  readonly samples: number;
}

export class Compose {
  private targets = new Map<string, Targets>();
  private readonly camera = new OrthographicCamera();
  private readonly quad: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly quadScene = new Scene();

  constructor(private readonly inputs: OutlineInputs) {
    this.quad = new Mesh(
      new PlaneGeometry(1, 1),
      new ShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: fullVertex,
        fragmentShader: composeFragment,
        uniforms: {
          scene: { value: null },
          depth: inputs.sceneDepth,
          outlines: { value: null },
          hasOutlines: { value: false },
          pixel: { value: new Vector2() },
          ratio: { value: 1 },
          nearFar: inputs.nearFar,
          reach: { value: 1 },
          accent: { value: new Vector3() },
          mark: { value: new Vector3() },
          rim: { value: new Vector3() },
          through: { value: new Vector2() },
        },
        blending: NoBlending,
        depthTest: false,
        depthWrite: false,
      }),
    );
    this.quad.frustumCulled = false;
    this.quadScene.add(this.quad);
  }

  setColours(accent: string, mark: string, rim: string): void {
    const set = (name: string, hex: string) => {
      const byte = (at: number) => Number.parseInt(hex.slice(at, at + 2), 16) / 255;
      (this.uniform(name).value as Vector3).set(byte(1), byte(3), byte(5));
    };
    set("accent", accent);
    set("mark", mark);
    set("rim", rim);
  }

  /// From 0, not at all, to 1.
  setThrough(accent: number, mark: number): void {
    (this.uniform("through").value as Vector2).set(accent, mark);
  }

  /// `reach`: how deep a step must be to be drawn as dark as any, in mm.
  render(
    renderer: WebGLRenderer,
    scene: Scene,
    outlineScene: Scene | null,
    camera: PerspectiveCamera,
    size: FrameSize,
    ratio: number,
    reach: number,
  ): void {
    const targets = this.targetsFor(size);
    this.inputs.nearFar.value.set(camera.near, camera.far);
    renderer.state.buffers.stencil.setClear(stencilMiddle);
    renderer.setRenderTarget(targets.scene);
    renderer.render(scene, camera);
    this.inputs.sceneDepth.value = targets.scene.depthTexture as DepthTexture;
    if (outlineScene) {
      // The outlines are smoothed where they are read: on fine screens that is enough.
      targets.outlines ??= target({ ...size, samples: ratio >= 1.5 ? 0 : size.samples }, false);
      renderer.setRenderTarget(targets.outlines);
      renderer.render(outlineScene, camera);
    }
    const canvas = renderer.getDrawingBufferSize(new Vector2());
    (this.uniform("pixel").value as Vector2).set(1 / canvas.x, 1 / canvas.y);
    this.uniform("ratio").value = ratio;
    this.uniform("reach").value = reach;
    this.uniform("scene").value = targets.scene.texture;
    this.uniform("outlines").value = targets.outlines?.texture ?? targets.scene.texture;
    this.uniform("hasOutlines").value = outlineScene !== null;
    renderer.setRenderTarget(null);
    renderer.render(this.quadScene, this.camera);
  }

  /// Lets go of what was drawn into; it is made anew when needed.
  release(): void {
    for (const { scene, outlines } of this.targets.values()) {
      scene.depthTexture?.dispose();
      scene.dispose();
      outlines?.dispose();
    }
    this.targets.clear();
  }

  dispose(): void {
    this.release();
    this.quad.geometry.dispose();
    this.quad.material.dispose();
  }

  private uniform(name: string): { value: unknown } {
    return this.quad.material.uniforms[name] as { value: unknown };
  }

  /// At most two kinds are kept: for pictures at rest and for those in motion.
  private targetsFor(size: FrameSize): Targets {
    const key = `${size.width} ${size.height} ${size.samples}`;
    let targets = this.targets.get(key);
    if (!targets) {
      if (this.targets.size >= 2) this.release();
      targets = { scene: target(size, true), outlines: null };
      this.targets.set(key, targets);
    }
    return targets;
  }
}

function target({ width, height, samples }: FrameSize, withDepth: boolean): WebGLRenderTarget {
  const made = new WebGLRenderTarget(width, height, {
    samples,
    stencilBuffer: true,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    resolveStencilBuffer: false,
    resolveDepthBuffer: withDepth,
  });
  if (withDepth) {
    const depth = new DepthTexture(width, height, UnsignedInt248Type);
    depth.format = DepthStencilFormat;
    depth.minFilter = depth.magFilter = NearestFilter;
    made.depthTexture = depth;
  }
  return made;
}
