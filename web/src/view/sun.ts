/// The shadows of the sun: a depth map seen from it, which the copies look into, and from that a soft shadow on the
/// ground. Neither depends on the viewer, so both are drawn only when copies change, and copies that come are drawn
/// into the map that is there.

import {
  DepthFormat,
  DepthTexture,
  DoubleSide,
  GLSL3,
  LessEqualCompare,
  LinearFilter,
  Matrix4,
  Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  UnsignedIntType,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";
import type { Box } from "./affine";
import { corners } from "./camera";
import { premultiplied } from "./materials";
import { tokens } from "./tokens";
import { type SharedUniforms, sunDirection } from "./uniforms";
import type { Theme } from "./view";

const groundSize = 192;
/// How far the ground's shadow is blurred, in relation to the box that casts it: all of it, and the part of it that lies
/// close under what stands there.
const wideBlur = 0.05;
const closeBlur = 0.012;

const bakeVertex = /* glsl */ `
void main() {
  gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
}
`;

/// The ground in the depth map: where the sun does not reach it.
const bakeFragment = /* glsl */ `
uniform highp sampler2DShadow sunDepth;
uniform mat4 sunMatrix;
uniform vec4 rectangle; // corner, size
uniform float texels;
out vec4 colour;

void main() {
  vec2 p = rectangle.xy + gl_FragCoord.xy / texels * rectangle.zw;
  vec3 q = (sunMatrix * vec4(p, 0.0, 1.0)).xyz;
  bool outside = any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0)));
  colour = vec4(outside ? 0.0 : 1.0 - texture(sunDepth, vec3(q.xy, min(q.z, 1.0))));
}
`;

/// One direction of a Gauss filter: red gets the wide one, green the close one.
const blurFragment = /* glsl */ `
uniform sampler2D shade;
uniform vec2 wide; // standard deviation, in texture units
uniform vec2 close;
uniform float texels;
out vec4 colour;

void main() {
  vec2 at = gl_FragCoord.xy / texels;
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int i = -8; i <= 8; ++i) {
    float t = float(i) / 3.2;
    float w = exp(-0.5 * t * t);
    sum += w * vec2(texture(shade, at + wide * t).r, texture(shade, at + close * t).g);
    weights += w;
  }
  colour = vec4(sum / weights, 0.0, 0.0);
}
`;

const groundVertex = /* glsl */ `
uniform vec4 rectangle;
out vec2 place;
void main() {
  place = position.xy + 0.5;
  gl_Position = projectionMatrix * viewMatrix * vec4(rectangle.xy + place * rectangle.zw, 0.0, 1.0);
}
`;

const groundFragment = /* glsl */ `
uniform sampler2D shade;
uniform vec4 tint; // as encoded; alpha: the darkest shadow
in vec2 place;
out vec4 colour;
void main() {
  vec2 s = texture(shade, place).rg;
  vec2 edge = min(place, 1.0 - place);
  float a = (0.72 * s.r + 0.28 * s.g) * tint.a * smoothstep(0.0, 0.06, min(edge.x, edge.y));
  colour = vec4(tint.rgb * a, a);
}
`;

export class Sun {
  /// On the ground, under all else.
  readonly ground: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly map: WebGLRenderTarget;
  private readonly groundMap = new WebGLRenderTarget(groundSize, groundSize, { depthBuffer: false });
  private readonly groundMap2 = new WebGLRenderTarget(groundSize, groundSize, { depthBuffer: false });
  private readonly camera = new OrthographicCamera();
  private readonly bake: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly blur: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly rectangle: { value: number[] } = { value: [0, 0, 1, 1] };
  private readonly nothing = new Scene();
  private bounds: Readonly<Box> | null = null;
  /// The longest side of what casts shadows, mm.
  private side = 1;

  /// `mapSize`: texels along a side of the depth map.
  constructor(
    private readonly shared: SharedUniforms,
    private readonly mapSize = 1024,
  ) {
    const depth = new DepthTexture(mapSize, mapSize, UnsignedIntType);
    depth.format = DepthFormat;
    depth.compareFunction = LessEqualCompare;
    depth.minFilter = depth.magFilter = LinearFilter;
    this.map = new WebGLRenderTarget(mapSize, mapSize, {
      depthTexture: depth,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    shared.sunDepth.value?.dispose();
    shared.sunDepth.value = depth;
    const plane = new PlaneGeometry(1, 1);
    const flat = (fragmentShader: string, uniforms: ShaderMaterial["uniforms"]) => {
      const mesh = new Mesh(
        plane,
        new ShaderMaterial({
          glslVersion: GLSL3,
          vertexShader: bakeVertex,
          fragmentShader,
          uniforms: { ...uniforms, texels: { value: groundSize } },
          blending: NoBlending,
          depthTest: false,
          depthWrite: false,
        }),
      );
      mesh.frustumCulled = false;
      return mesh;
    };
    const { sunDepth, sunMatrix } = shared;
    this.bake = flat(bakeFragment, { sunDepth, sunMatrix, rectangle: this.rectangle });
    this.blur = flat(blurFragment, {
      shade: { value: null },
      wide: { value: new Vector2() },
      close: { value: new Vector2() },
    });
    this.ground = new Mesh(
      plane,
      new ShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: groundVertex,
        fragmentShader: groundFragment,
        uniforms: {
          rectangle: this.rectangle,
          shade: { value: this.groundMap.texture },
          tint: { value: [0, 0, 0, 0] },
        },
        ...premultiplied,
        side: DoubleSide,
        depthWrite: false,
      }),
    );
    this.ground.frustumCulled = false;
    this.ground.visible = false;
    this.setTheme("light");
  }

  setTheme(theme: Theme): void {
    const hex = tokens(theme).shadow;
    const byte = (at: number) => Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    this.set(this.ground, "tint", [byte(1), byte(3), byte(5), theme === "dark" ? 0.6 : 0.3]);
  }

  /// Whether copies in this box can be added to the map as it is.
  holds(box: Readonly<Box>): boolean {
    const b = this.bounds;
    return b !== null && [0, 1, 2].every((i) => at(box, i) >= at(b, i) - 1e-3 && at(box, i + 3) <= at(b, i + 3) + 1e-3);
  }

  /// Draws the shadows of what is in `scene`; `add`: over those that are there. `box` holds all that casts one.
  render(renderer: WebGLRenderer, scene: Scene, box: Readonly<Box>, add: boolean): void {
    if (!add) this.look(box);
    const target = renderer.getRenderTarget();
    const autoClear = renderer.autoClear;
    renderer.autoClear = !add;
    renderer.setRenderTarget(this.map);
    renderer.render(scene, this.camera);
    renderer.autoClear = autoClear;
    renderer.setRenderTarget(target);
  }

  /// Nothing casts a shadow.
  clear(renderer: WebGLRenderer, box: Readonly<Box>): void {
    this.render(renderer, this.nothing, box, false);
    this.forget();
  }

  /// The ground's shadow, from the map as it is now.
  renderGround(renderer: WebGLRenderer): void {
    const target = renderer.getRenderTarget();
    renderer.setRenderTarget(this.groundMap);
    renderer.render(this.bake, this.camera);
    const [, , width, height] = this.rectangle.value as [number, number, number, number];
    for (const [from, to, x, y] of [
      [this.groundMap, this.groundMap2, 1 / width, 0],
      [this.groundMap2, this.groundMap, 0, 1 / height],
    ] as const) {
      this.set(this.blur, "shade", from.texture);
      this.set(this.blur, "wide", new Vector2(x, y).multiplyScalar(wideBlur * this.side));
      this.set(this.blur, "close", new Vector2(x, y).multiplyScalar(closeBlur * this.side));
      renderer.setRenderTarget(to);
      renderer.render(this.blur, this.camera);
    }
    renderer.setRenderTarget(target);
  }

  showGround(show: boolean): void {
    this.ground.visible = show && this.bounds !== null;
  }

  /// What the map showed is gone.
  forget(): void {
    this.bounds = null;
  }

  dispose(): void {
    this.map.depthTexture?.dispose();
    this.map.dispose();
    this.groundMap.dispose();
    this.groundMap2.dispose();
    this.bake.geometry.dispose();
    this.bake.material.dispose();
    this.blur.material.dispose();
    this.ground.material.dispose();
  }

  /// Points the map's camera at a box, and lays the ground's rectangle under its shadow.
  private look(box: Readonly<Box>): void {
    this.bounds = [...box] as Box;
    const side = Math.max(1e-3, box[3] - box[0], box[4] - box[1], box[5] - box[2]);
    const centre = new Vector3((box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2);
    const camera = this.camera;
    camera.up.set(0, 1, 0);
    camera.position.copy(centre).addScaledVector(sunDirection, 4 * side);
    camera.lookAt(centre);
    camera.updateMatrixWorld();
    let reach = 0;
    const p = new Vector3();
    const rectangle = [Infinity, Infinity, -Infinity, -Infinity];
    for (const corner of corners(box)) {
      p.set(...corner).applyMatrix4(camera.matrixWorldInverse);
      reach = Math.max(reach, Math.abs(p.x), Math.abs(p.y));
      // Where this corner's shadow falls, and the corner's own foot.
      for (const height of [Math.max(0, corner[2]), 0]) {
        const x = corner[0] - (sunDirection.x / sunDirection.z) * height;
        const y = corner[1] - (sunDirection.y / sunDirection.z) * height;
        rectangle[0] = Math.min(rectangle[0] as number, x);
        rectangle[1] = Math.min(rectangle[1] as number, y);
        rectangle[2] = Math.max(rectangle[2] as number, x);
        rectangle[3] = Math.max(rectangle[3] as number, y);
      }
    }
    reach *= 1.02;
    camera.left = camera.bottom = -reach;
    camera.right = camera.top = reach;
    camera.near = 2 * side;
    camera.far = 6 * side;
    camera.updateProjectionMatrix();
    const half = new Matrix4().set(0.5, 0, 0, 0.5, 0, 0.5, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0, 1);
    this.shared.sunMatrix.value.copy(half).multiply(camera.projectionMatrix).multiply(camera.matrixWorldInverse);
    this.shared.sunBias.value.set((2.3 * 2 * reach) / this.mapSize, 1 / this.mapSize);
    this.side = side;
    const [x0, y0, x1, y1] = rectangle as [number, number, number, number];
    const spare = 2.6 * wideBlur * side;
    this.rectangle.value = [x0 - spare, y0 - spare, x1 - x0 + 2 * spare, y1 - y0 + 2 * spare];
    this.set(this.ground, "rectangle", this.rectangle.value);
    this.set(this.bake, "rectangle", this.rectangle.value);
  }

  private set(mesh: Mesh<PlaneGeometry, ShaderMaterial>, name: string, value: unknown): void {
    const uniform = mesh.material.uniforms[name];
    if (uniform) uniform.value = value;
  }
}

function at(box: Readonly<Box>, i: number): number {
  return box[i] as number;
}
