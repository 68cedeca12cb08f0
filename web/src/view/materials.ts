/// The materials that copies are drawn with, and the states of the passes among them.
///
/// Cut faces come from three passes before the copies themselves. Where a line of sight comes through the section plane
/// inside a solid, it meets one more inner side than outer sides behind the plane:
///
/// 1. inner sides: drawn as cut faces, counted up in the stencil;
/// 2. outer sides: counted down;
/// 3. the plane: where the count is positive its depth is written, so that nothing behind the cut face shows.
///
/// Everything else is then drawn as always and covers what the first pass drew in vain. It costs two passes over the
/// few copies that the plane crosses, whichever way they lie, and shells of a mesh that run into each other count right.

import {
  AlwaysDepth,
  AlwaysStencilFunc,
  BackSide,
  CustomBlending,
  DecrementWrapStencilOp,
  DoubleSide,
  FrontSide,
  GLSL3,
  GreaterEqualStencilFunc,
  IncrementWrapStencilOp,
  KeepStencilOp,
  LessStencilFunc,
  MaxEquation,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  type ShaderMaterialParameters,
} from "three";
import * as shaders from "./shaders";
import type { SharedUniforms } from "./uniforms";

/// The stencil starts in the middle, so that it can be counted down, too.
export const stencilMiddle = 128;

export const premultiplied: ShaderMaterialParameters = {
  blending: CustomBlending,
  blendSrc: OneFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
};

export interface OutlineUniforms {
  readonly [name: string]: { value: unknown };
}

export interface Materials {
  readonly solid: ShaderMaterial;
  /// For meshes that are open, or whose copies are mirrored: both sides may be seen.
  readonly solidBoth: ShaderMaterial;
  readonly cutInner: ShaderMaterial;
  readonly cutOuter: ShaderMaterial;
  readonly cutPlane: ShaderMaterial;
  readonly ghostDepth: ShaderMaterial;
  readonly ghost: ShaderMaterial;
  readonly forgetDepth: ShaderMaterial;
  readonly outline: ShaderMaterial;
  readonly outlineInner: ShaderMaterial;
  readonly outlineErase: ShaderMaterial;
  readonly shadow: ShaderMaterial;
}

export function makeMaterials(shared: SharedUniforms, outline: OutlineUniforms): Materials {
  const copies = (
    fragmentShader: string,
    more: ShaderMaterialParameters,
    uniforms: Record<string, unknown> = shared,
  ) => {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: shaders.copyVertex,
      fragmentShader,
      uniforms: uniforms as ShaderMaterial["uniforms"],
      blending: NoBlending,
      side: DoubleSide,
      ...more,
    });
    // What a mesh without normals has: the shader then takes its facets'.
    Object.assign(material.defaultAttributeValues, { normal: [0, 0, 0] });
    return material;
  };
  const flat = (more: ShaderMaterialParameters) =>
    new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: shaders.planeVertex,
      fragmentShader: shaders.plainFragment,
      blending: NoBlending,
      side: DoubleSide,
      ...more,
    });
  const count = (up: boolean): ShaderMaterialParameters => ({
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilFail: KeepStencilOp,
    stencilZFail: up ? IncrementWrapStencilOp : DecrementWrapStencilOp,
    stencilZPass: up ? IncrementWrapStencilOp : DecrementWrapStencilOp,
  });
  const keepStencil = { stencilFail: KeepStencilOp, stencilZFail: KeepStencilOp, stencilZPass: KeepStencilOp };
  const unseen = { colorWrite: false, depthWrite: false, depthTest: false };
  const withOutline = { ...shared, ...outline };
  return {
    solid: copies(shaders.solidFragment, { side: FrontSide }),
    solidBoth: copies(shaders.solidFragment, {}),
    cutInner: copies(shaders.cutFragment, { side: BackSide, ...count(true) }),
    cutOuter: copies(shaders.depthFragment, { side: FrontSide, ...unseen, ...count(false) }),
    cutPlane: flat({
      colorWrite: false,
      depthFunc: AlwaysDepth,
      stencilWrite: true,
      stencilFunc: LessStencilFunc,
      stencilRef: stencilMiddle,
      ...keepStencil,
    }),
    // What was drawn faint leaves its colours and no depth: it hides nothing, and has no edges.
    forgetDepth: new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: shaders.farVertex,
      fragmentShader: shaders.plainFragment,
      colorWrite: false,
      depthFunc: AlwaysDepth,
    }),
    ghostDepth: copies(shaders.depthFragment, { colorWrite: false }),
    ghost: copies(shaders.ghostFragment, { ...premultiplied, depthWrite: false }),
    outline: copies(
      shaders.outlineFragment,
      {
        depthTest: false,
        depthWrite: false,
        blending: CustomBlending,
        blendEquation: MaxEquation,
        blendSrc: OneFactor,
        blendDst: OneFactor,
      },
      withOutline,
    ),
    outlineInner: copies(shaders.outlineCutFragment, { side: BackSide, ...count(true) }),
    outlineErase: flat({
      depthTest: false,
      depthWrite: false,
      stencilWrite: true,
      stencilFunc: GreaterEqualStencilFunc,
      stencilRef: stencilMiddle,
      ...keepStencil,
    }),
    shadow: copies(shaders.depthFragment, { colorWrite: false }),
  };
}

export function disposeMaterials(materials: Materials): void {
  for (const material of Object.values(materials) as ShaderMaterial[]) material.dispose();
}
