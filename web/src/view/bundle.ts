/// Reads a bundle of meshes as the server sends it. Little-endian:
///
///   "SPMB", uint32 version, uint32 number of meshes; then each mesh:
///   uint32 id, uint32 n (vertices), uint32 m (triangles), float32 corner[3], float32 step[3],
///   3 n uint16 (vertex = corner + step * number), zeros up to a multiple of 4 bytes, 3 m uint32 indices.

import type { MeshData } from "./view";

const magic = 0x424d5053; // "SPMB"
const version = 1;
const headBytes = 12;
const meshHeadBytes = 36;

/// Throws an Error that says what is wrong, and where.
export function readBundle(buffer: ArrayBuffer): MeshData[] {
  const view = new DataView(buffer);
  if (buffer.byteLength < headBytes) throw new Error("The mesh bundle is cut short: its head is missing.");
  if (view.getUint32(0, true) !== magic) throw new Error("This is not a mesh bundle.");
  if (view.getUint32(4, true) !== version) {
    throw new Error(`The mesh bundle has version ${view.getUint32(4, true)}; this page reads version ${version}.`);
  }
  const count = view.getUint32(8, true);
  // Checked before any memory is taken: a wrong number must not ask for gigabytes.
  if (count * meshHeadBytes > buffer.byteLength - headBytes) {
    throw new Error(`The mesh bundle is cut short: ${count} meshes do not fit into ${buffer.byteLength} bytes.`);
  }
  const meshes: MeshData[] = [];
  let at = headBytes;
  for (let i = 0; i < count; ++i) {
    const { mesh, end } = readMesh(buffer, view, at, i);
    meshes.push(mesh);
    at = end;
  }
  if (at !== buffer.byteLength) {
    throw new Error(`The mesh bundle has ${buffer.byteLength - at} bytes after its last mesh.`);
  }
  return meshes;
}

function readMesh(buffer: ArrayBuffer, view: DataView, start: number, number: number): { mesh: MeshData; end: number } {
  const where = `Mesh ${number + 1} of the bundle`;
  if (start + meshHeadBytes > buffer.byteLength) throw new Error(`${where} is cut short in its head.`);
  const id = view.getUint32(start, true);
  const vertices = view.getUint32(start + 4, true);
  const triangles = view.getUint32(start + 8, true);
  const corner = [0, 1, 2].map((i) => view.getFloat32(start + 12 + 4 * i, true));
  const step = [0, 1, 2].map((i) => view.getFloat32(start + 24 + 4 * i, true));
  if (![...corner, ...step].every(Number.isFinite)) throw new Error(`${where} has a corner or a step without end.`);

  const numbersAt = start + meshHeadBytes;
  const indicesAt = numbersAt + 4 * Math.ceil((6 * vertices) / 4);
  const end = indicesAt + 12 * triangles;
  if (end > buffer.byteLength) {
    throw new Error(`${where} is cut short: ${vertices} vertices and ${triangles} triangles are announced.`);
  }

  const positions = new Float32Array(3 * vertices);
  for (let i = 0; i < positions.length; ++i) {
    const axis = i % 3;
    positions[i] = (corner[axis] ?? 0) + (step[axis] ?? 0) * view.getUint16(numbersAt + 2 * i, true);
  }
  const indices = new Uint32Array(3 * triangles);
  for (let i = 0; i < indices.length; ++i) {
    const index = view.getUint32(indicesAt + 4 * i, true);
    if (index >= vertices) throw new Error(`${where} has vertex ${index} in a triangle, but ${vertices} vertices.`);
    indices[i] = index;
  }
  return { mesh: { id, positions, indices }, end };
}
