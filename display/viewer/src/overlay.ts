// The maps of a primitive, as a mesh over it: in space, and flat over the texture.
import { BufferGeometry, Float32BufferAttribute, InstancedMesh, Mesh, type ShaderMaterial, Uint32BufferAttribute, Vector2 } from "three";

import type { Mapped } from "./load";
import type { Packed } from "./shader";

const none: Packed = [0, 0, 0];

function packed({ entries }: Mapped): Uint32BufferAttribute {
  const numbers = entries.flatMap((entry) => {
    const one: Packed = !entry ? none : "state" in entry ? [entry.state, 0, 0] : [entry.record.offset, entry.record.level, entry.record.states === 2 ? 1 : 2];
    return [...one, ...one, ...one];
  });
  return new Uint32BufferAttribute(numbers, 3);
}

/** The UV of a vertex by which its base colour is sampled; the texture has glTF's transform. */
export function uvOf({ mesh, material }: Mapped, vertex: number): Vector2 {
  const uvs = mesh.geometry.getAttribute(material.map?.channel ? `uv${material.map.channel}` : "uv");
  if (!uvs) return new Vector2();
  material.map?.updateMatrix();
  const uv = new Vector2(uvs.getX(vertex), uvs.getY(vertex));
  return material.map ? uv.applyMatrix3(material.map.matrix) : uv;
}

export interface Overlay {
  of: Mapped;
  /** A child of the primitive's mesh. */
  inSpace: Mesh<BufferGeometry, ShaderMaterial>;
  /** At the UVs: u to the right, v down. */
  onTexture: Mesh<BufferGeometry, ShaderMaterial>;
}

export function overlay(of: Mapped, material: ShaderMaterial, flat: ShaderMaterial): Overlay {
  const { geometry } = of.mesh;
  const corners = Array.from({ length: 3 * of.entries.length }, (_, k) => geometry.index?.getX(k) ?? k);
  const position = geometry.getAttribute("position");
  const entry = packed(of);
  const weights = new Float32BufferAttribute(corners.flatMap((_, k) => [[0, 0], [1, 0], [0, 1]][k % 3]!), 2);
  const made = (positions: number[], looks: ShaderMaterial): Mesh<BufferGeometry, ShaderMaterial> => {
    const one = new BufferGeometry();
    one.setAttribute("position", new Float32BufferAttribute(positions, 3));
    one.setAttribute("weights", weights);
    one.setAttribute("entry", entry);
    const several = looks === material && of.mesh instanceof InstancedMesh ? of.mesh : null;
    const mesh = several ? new InstancedMesh(one, looks, several.count) : new Mesh(one, looks);
    if (several) (mesh as InstancedMesh).instanceMatrix = several.instanceMatrix;
    mesh.renderOrder = 1;
    return mesh;
  };
  return {
    of,
    inSpace: made(corners.flatMap((k) => [position.getX(k), position.getY(k), position.getZ(k)]), material),
    onTexture: made(corners.flatMap((k) => (({ x, y }) => [x, -y, 0])(uvOf(of, k))), flat),
  };
}
