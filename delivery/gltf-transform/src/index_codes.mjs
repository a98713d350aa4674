// The buffer of indices, from and to bytes.

/** The component types: 5124, 32 bits signed, is one of this extension's alone. */
const types = new Map([
  [5121, Uint8Array],
  [5122, Int16Array],
  [5123, Uint16Array],
  [5124, Int32Array],
  [5125, Uint32Array],
]);
const specials = 4;

function typeOf(componentType, what) {
  const type = types.get(componentType);
  if (!type) throw new Error(`${what}: componentType ${componentType} is not one of ${[...types.keys()].join(", ")}`);
  return type;
}

/** `count` numbers at `offset`, `stride` bytes apart, or side by side. */
function numbers(Type, bytes, offset, count, stride, what) {
  const size = Type.BYTES_PER_ELEMENT;
  if (count > 0 && offset + (count - 1) * stride + size > bytes.length)
    throw new Error(`${what}: its bytes end beyond its bufferView`);
  const packed = new Uint8Array(size * count);
  for (let k = 0; k < count; ++k) packed.set(bytes.subarray(offset + k * stride, offset + k * stride + size), k * size);
  return new Type(packed.buffer);
}

/** Codes of an accessor, special ones from -1 to -4 in each type.  `view`: the bytes of a bufferView, decoded. */
export function readCodes(accessor, view, strideOf, what) {
  const Type = typeOf(accessor.componentType, what);
  const size = Type.BYTES_PER_ELEMENT;
  const values =
    accessor.bufferView === undefined
      ? new Type(accessor.count)
      : numbers(
          Type,
          view(accessor.bufferView),
          accessor.byteOffset ?? 0,
          accessor.count,
          strideOf(accessor.bufferView) || size,
          what,
        );
  if (accessor.sparse) {
    const { count, indices, values: given } = accessor.sparse;
    const Index = typeOf(indices.componentType, what);
    const places = numbers(
      Index,
      view(indices.bufferView),
      indices.byteOffset ?? 0,
      count,
      Index.BYTES_PER_ELEMENT,
      what,
    );
    numbers(Type, view(given.bufferView), given.byteOffset ?? 0, count, size, what).forEach(
      (value, k) => (values[places[k]] = value),
    );
  }
  // In an unsigned type the four greatest numbers are the special ones.
  const limit = Type === Uint8Array ? 2 ** 8 : Type === Uint16Array ? 2 ** 16 : Infinity;
  return Int32Array.from(values, (value) => (value >= limit - specials ? value - limit : value | 0));
}

/** Whether a type can store records up to `greatest`. */
const holds = (componentType, greatest) =>
  greatest < { 5121: 2 ** 8 - specials, 5122: 2 ** 15, 5123: 2 ** 16 - specials }[componentType] ||
  componentType >= 5124;

/** This type if it can store the codes, else the least unsigned one that can. */
export function roomyType(componentType, codes) {
  const greatest = codes.reduce((a, b) => Math.max(a, b), 0);
  return holds(componentType, greatest) ? componentType : holds(5123, greatest) ? 5123 : 5125;
}

/** The bytes of codes.  Errors: a code that the type cannot store. */
export function writeCodes(componentType, codes, what) {
  const Type = typeOf(componentType, what);
  if (roomyType(componentType, codes) !== componentType)
    throw new Error(`${what}: componentType ${componentType} is too small for its records`);
  return new Uint8Array(new Type(codes).buffer);
}
