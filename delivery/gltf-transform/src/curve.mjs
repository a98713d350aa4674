// The order of a map's states, and what becomes of it where a triangle's corners are permuted.

/** Every other bit of the result is a bit of x.  Domain: x below 2^16. */
function spread(x) {
  x = (x | (x << 8)) & 0x00ff00ff;
  x = (x | (x << 4)) & 0x0f0f0f0f;
  x = (x | (x << 2)) & 0x33333333;
  return (x | (x << 1)) & 0x55555555;
}

/**
 * The index of a micro-triangle on the curve: iw = NOT(i+j), one less in the upper half of a square;
 * b0 = NOT(i XOR iw), t = (i XOR j) AND b0, f = XOR of t from above, b1 = ((f XOR i) AND NOT b0) OR t; b0 in the even
 * bits, b1 in the odd ones.
 * Domain: level 0..12; i, j: its square on the grid of u and v; upper: it is the upper half of the square.
 * Source: VK_EXT_opacity_micromap, appendix "Reference Code".
 */
export function curveIndex(i, j, upper, level) {
  const low = (1 << level) - 1;
  const iw = ~(i + j) - (upper ? 1 : 0);
  const b0 = ~(i ^ iw) & low;
  const t = (i ^ j) & b0;
  let f = t ^ (t >>> 1);
  f ^= f >>> 2;
  f ^= f >>> 4;
  f ^= f >>> 8;
  const b1 = (((f ^ i) & ~b0) | t) & low;
  return (spread(b0) | (spread(b1) << 1)) >>> 0;
}

const made = new Map();
/** Tables up to this level are kept: all six take 1.5 MB at level 8. */
const kept = 8; /* check-magic: 1572864 == 6 * 4 * 4^8 */

/**
 * Where the states of a permuted triangle's map lie in its old map: state k of the new map is state result[k] of the
 * old.  Corner c of the new triangle is corner `corners[c]` of the old one; corners 0, 1, 2 have the weights w, u, v.
 */
export function permutation(level, corners) {
  const key = `${level}:${corners}`;
  const known = made.get(key);
  if (known) return known;
  const size = 2 ** level;
  const from = new Uint32Array(4 ** level);
  const weights = [0, 0, 0];
  for (let i = 0; i < size; ++i)
    for (let j = 0; i + j < size; ++j)
      for (const upper of i + j + 1 < size ? [0, 1] : [0]) {
        // Thirds of a square's side: the centre of a lower half lies 1 beyond the square's corner, of an upper half 2.
        const u = 3 * i + 1 + upper,
          v = 3 * j + 1 + upper;
        weights[corners[0]] = 3 * size - u - v;
        weights[corners[1]] = u;
        weights[corners[2]] = v;
        const [, oldU, oldV] = weights;
        from[curveIndex(i, j, upper === 1, level)] = curveIndex(
          Math.floor(oldU / 3),
          Math.floor(oldV / 3),
          oldU % 3 === 2,
          level,
        );
      }
  if (level <= kept) made.set(key, from);
  return from;
}
