// Reads states from the graph of a scene's maps, in the container of docs/DAG.md.
//
// Before the include MM_DAG_WORD(k) has to be defined: word k of the container, four bytes, the first the lowest.
#ifndef MMVERIFY_SHADERS_DAG
#define MMVERIFY_SHADERS_DAG

const uint mm_dag_header = 8u;  // words before the records

/// The starts of the arrays, in words of the container, and the bits of a state.
struct MmDag {
  uint bits, tiles, flat_maps, nodes;
};

/// Reads the container's header. For many lookups, keep it in push constants.
MmDag mm_dag_open() {
  uint bits = MM_DAG_WORD(1) >> 8 & 3u;
  uint tiles = mm_dag_header + 2u * MM_DAG_WORD(2);
  uint flat_maps = tiles + 2u * bits * MM_DAG_WORD(3);
  return MmDag(bits, tiles, flat_maps, flat_maps + 2u * bits * MM_DAG_WORD(4));
}

/// Domain: map below the container's number of maps.
uint mm_dag_level(uint map) { return MM_DAG_WORD(mm_dag_header + 2u * map) & 0xffu; }

/// State number `index` of the states that are packed from word `at` on.
uint mm_dag_packed(uint at, uint bits, uint index) {
  uint bit = index * bits;
  return MM_DAG_WORD(at + (bit >> 5)) >> (bit & 31u) & (2u * bits - 1u);
}

/// The state below a node of level m > 3: two words a node, which takes 4 bits of the index, at the top of an even level 2;
/// then a word of a tile.  No way leads back.
///   halfwords of a node: which children are mixed, the low bits of the others' states, in 4-state the high bits
///   reference of a mixed child: 32 bits in a wide node, whose reference is odd; 16 bits in a narrow one
uint mm_dag_below(MmDag dag, uint reference, uint m, uint index) {
  while (true) {
    uint node = dag.nodes + (reference >> 1);
    bool narrow = (reference & 1u) == 0u;
    uint below = m - 2u + (m + 1u & 1u);
    uint child = index >> 2u * below & ((m & 1u) == 0u ? 3u : 15u);
    uint first = MM_DAG_WORD(node);
    if ((first >> child & 1u) == 0u) {
      uint low = first >> (16u + child) & 1u;
      return dag.bits == 1u ? low : low | (MM_DAG_WORD(node + 1u) >> child & 1u) << 1;
    }
    uint rank = uint(bitCount(first & ((1u << child) - 1u)));
    if (narrow) {
      uint halfword = 1u + dag.bits + rank;
      reference = MM_DAG_WORD(node + (halfword >> 1)) >> 16u * (halfword & 1u) & 0xffffu;
    } else {
      reference = MM_DAG_WORD(node + dag.bits + rank);
    }
    if (below == 3u) return mm_dag_packed(dag.tiles + 2u * dag.bits * reference, dag.bits, index & 63u);
    m = below;
  }
}

/// The state at an index of a map.
/// Domain: map below the container's number of maps, index < 4^level; bytes that are a container.
/// Source: docs/DAG.md, "The form".
uint mm_dag_lookup(MmDag dag, uint map, uint index) {
  const uint small = 0u, uniform_map = 1u, tile = 2u, node = 3u;
  uint record = MM_DAG_WORD(mm_dag_header + 2u * map), value = MM_DAG_WORD(mm_dag_header + 2u * map + 1u);
  uint level = record & 0xffu, kind = record >> 8 & 0xffu;
  if (kind == small) return value >> index * dag.bits & (2u * dag.bits - 1u);
  if (kind == uniform_map) return value;
  if (kind == node) return mm_dag_below(dag, value, level, index);
  uint units = 2u * dag.bits * value;
  return mm_dag_packed((kind == tile ? dag.tiles : dag.flat_maps) + units, dag.bits, index);
}

#endif
