// The opacity micromaps that a .glb holds (EXT_mesh_opacity_micromap, docs/GLTF.md): records and states.

export interface MapRecord {
  level: number;
  /** Where its states begin, in bytes of the array's data. */
  offset: number;
  /** 2 or 4. */
  states: number;
  /** A state of 0..3 for each micro-triangle, in the order of the index. */
  at: (index: number) => number;
}

interface View {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
}
interface Gltf {
  bufferViews?: View[];
  extensions?: Record<string, { micromaps?: { data: number; triangles: number }[] }>;
}

const names = ["EXT_mesh_opacity_micromap", "KHR_mesh_opacity_micromap"];

/** The chunks of a .glb; null where it is none. Source: glTF 2.0, 4.4. */
function chunks(file: Uint8Array): { json: Gltf; bin: Uint8Array } | null {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (file.length < 20 || view.getUint32(0, true) !== 0x46546c67) return null;
  let json: Gltf | undefined;
  let bin: Uint8Array = new Uint8Array();
  for (let at = 12; at + 8 <= file.length; ) {
    const size = view.getUint32(at, true);
    const kind = view.getUint32(at + 4, true);
    const part = file.subarray(at + 8, at + 8 + size);
    if (kind === 0x4e4f534a) json = JSON.parse(new TextDecoder().decode(part)) as Gltf;
    else if (kind === 0x004e4942) bin = part;
    at += 8 + size;
  }
  return json ? { json, bin } : null;
}

/** Empty where the file has none, or none that can be read: what is wrong with it, `validate` says. */
export function readMaps(file: Uint8Array): MapRecord[] {
  try {
    const found = chunks(file);
    if (!found) return [];
    const { json, bin } = found;
    const arrays = names.flatMap((name) => json.extensions?.[name]?.micromaps ?? []);
    return arrays.flatMap(({ data, triangles }) => {
      const bytes = (k: number): Uint8Array => {
        const { byteOffset = 0, byteLength } = json.bufferViews![k]!;
        return bin.subarray(byteOffset, byteOffset + byteLength);
      };
      return records(bytes(data), bytes(triangles)).filter((record) => record !== null);
    });
  } catch {
    return [];
  }
}

/** Records of 8 bytes: offset (32 bits), level and format (16 bits each); format 1 has 1 bit a state, 2 has 2, from the
 * lowest bits up. Null: one that cannot be read. Source: Vulkan, VkMicromapTriangleEXT. */
export function records(data: Uint8Array, triangles: Uint8Array): (MapRecord | null)[] {
  const view = new DataView(triangles.buffer, triangles.byteOffset, triangles.byteLength);
  const all: (MapRecord | null)[] = [];
  for (let at = 0; at + 8 <= triangles.length; at += 8) {
    const offset = view.getUint32(at, true);
    const level = view.getUint16(at + 4, true);
    const bits = view.getUint16(at + 6, true);
    if (level > 12 || (bits !== 1 && bits !== 2) || offset + Math.ceil((bits * 4 ** level) / 8) > data.length) {
      all.push(null);
      continue;
    }
    const each = 8 / bits;
    all.push({ level, offset, states: 2 ** bits, at: (index) => (data[offset + Math.floor(index / each)]! >> (bits * (index % each))) & (2 ** bits - 1) });
  }
  return all;
}
