/// What all copies' shaders share. One object per value: a change is seen by every material.

import {
  Data3DTexture,
  type DataTexture,
  DepthTexture,
  type IUniform,
  LinearFilter,
  Matrix4,
  RGBAFormat,
  type Texture,
  UnsignedByteType,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import { type Ambient, openAmbient } from "./ambient";
import type { Theme } from "./view";

/// Towards the sun: from the front, the left and above. It stays where it is while the viewer goes round, as the shadow
/// on the ground does.
export const sunDirection = new Vector3(-0.36, -0.5, 0.8).normalize();

export interface SharedUniforms {
  readonly [name: string]: IUniform;
  readonly list: IUniform<DataTexture | null>;
  readonly copyData: IUniform<DataTexture | null>;
  readonly eye: IUniform<Vector3>;
  readonly plane: IUniform<Vector4>;
  readonly hatchStep: IUniform<number>;
  readonly sun: IUniform<Vector3>;
  readonly sunDepth: IUniform<Texture | null>;
  readonly sunMatrix: IUniform<Matrix4>;
  readonly sunBias: IUniform<Vector2>;
  readonly ambient: IUniform<Data3DTexture>;
  readonly ambientCorner: IUniform<Vector3>;
  readonly ambientScale: IUniform<Vector3>;
  readonly ambientCell: IUniform<number>;
  readonly skyLight: IUniform<Vector3>;
  readonly groundLight: IUniform<Vector3>;
  readonly sunLight: IUniform<Vector3>;
}

/// Keeps everything: no section.
export const noPlane: readonly [number, number, number, number] = [0, 0, 0, 1];

export function sharedUniforms(): SharedUniforms {
  const uniforms: SharedUniforms = {
    list: { value: null },
    copyData: { value: null },
    eye: { value: new Vector3() },
    plane: { value: new Vector4(...noPlane) },
    hatchStep: { value: 4 },
    sun: { value: sunDirection },
    sunDepth: { value: new DepthTexture(1, 1) },
    sunMatrix: { value: new Matrix4() },
    sunBias: { value: new Vector2(0, 0) },
    ambient: { value: new Data3DTexture(null, 1, 1, 1) },
    ambientCorner: { value: new Vector3() },
    ambientScale: { value: new Vector3(1, 1, 1) },
    ambientCell: { value: 0 },
    skyLight: { value: new Vector3() },
    groundLight: { value: new Vector3() },
    sunLight: { value: new Vector3() },
  };
  setAmbient(uniforms, openAmbient());
  setLights(uniforms, "light");
  return uniforms;
}

/// The sky is a little blue and the sun a little yellow, as daylight is: shadows look deep instead of dirty.
export function setLights(uniforms: SharedUniforms, theme: Theme): void {
  const dim = theme === "dark" ? 0.94 : 1;
  uniforms.skyLight.value.set(0.6, 0.615, 0.64).multiplyScalar(dim);
  uniforms.groundLight.value.set(0.3, 0.3, 0.31).multiplyScalar(dim);
  uniforms.sunLight.value.set(0.76, 0.745, 0.71).multiplyScalar(dim);
}

export function setAmbient(uniforms: SharedUniforms, ambient: Ambient): void {
  const [nx, ny, nz] = ambient.size;
  const texture = new Data3DTexture(ambient.texels, nx, ny, nz);
  texture.format = RGBAFormat;
  texture.type = UnsignedByteType;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  uniforms.ambient.value.dispose();
  uniforms.ambient.value = texture;
  uniforms.ambientCorner.value.set(...ambient.corner);
  uniforms.ambientScale.value.set(1 / (nx * ambient.cell), 1 / (ny * ambient.cell), 1 / (nz * ambient.cell));
  uniforms.ambientCell.value = ambient.cell;
}
