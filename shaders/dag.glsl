// A state out of the graph of a scene's maps: the container of docs/DAG.md, its arrays where they lie in it.
//
// Before the include MM_DAG_WORD(k) has to be defined: word k of the container, four bytes, the first the lowest.
#ifndef MMVERIFY_SHADERS_DAG
#define MMVERIFY_SHADERS_DAG

/// Where the arrays begin, in words.  Whoever keeps them in buffers of their own needs none of it.
struct MmDag {
  uint tiles, flat_maps, nodes;
};
const uint mm_dag_records = 8u;

/// From the header: words 2, 3 and 4 count maps, tiles and units of flat.  `bits`: of a state, 1 or 2.
MmDag mm_dag_arrays(uint bits) {
  uint tiles = mm_dag_records + 2u * MM_DAG_WORD(2u);
  uint flat_maps = tiles + 2u * bits * MM_DAG_WORD(3u);
  return MmDag(tiles, flat_maps, flat_maps + 2u * bits * MM_DAG_WORD(4u));
}

/// State `index` of those that are packed from a word on.
uint mm_dag_packed(uint word, uint bits, uint index) {
  uint bit = index * bits;
  return MM_DAG_WORD(word + (bit >> 5)) >> (bit & 31u) & ((1u << bits) - 1u);
}

/// The state at an index of a map: a record of two words, two words a node, one of a tile; no way back.
///   node of level m: 16 children of level m-2, or 4 of level m-1 where m is even; halfword 0 says which are mixed,
///   halfwords 1 and 2 the states of the others; references of the mixed ones, in order, in halfwords from 1 + bits on,
///   or, of a wide node, in words from `bits` on
/// Domain: a container of mmverify::impl::dag::save with states of `bits`, map < its maps, and the low 2 level bits of the
/// index count.
uint mm_dag_lookup(uint bits, uint map, uint index) {
  MmDag dag = mm_dag_arrays(bits);
  uint record = MM_DAG_WORD(mm_dag_records + 2u * map), value = MM_DAG_WORD(mm_dag_records + 2u * map + 1u);
  uint level = record & 0xffu, kind = record >> 8 & 0xffu;
  index &= (1u << 2u * level) - 1u;
  if (kind == 0u) return value >> index * bits & ((1u << bits) - 1u);
  if (kind == 1u) return value;
  if (kind == 4u) return mm_dag_packed(dag.flat_maps + 2u * bits * value, bits, index);
  while (level > 3u) {
    uint even = ~level & 1u, at = dag.nodes + (value >> 1);
    level -= 2u - even;
    uint child = index >> 2u * level & (even != 0u ? 3u : 15u);
    uint first = MM_DAG_WORD(at);
    if ((first >> child & 1u) == 0u) {
      uint state = first >> 16u + child & 1u;
      return bits == 1u ? state : state | (MM_DAG_WORD(at + 1u) >> child & 1u) << 1;
    }
    uint rank = uint(bitCount(first & (1u << child) - 1u)), halfword = 1u + bits + rank;
    value = (value & 1u) != 0u ? MM_DAG_WORD(at + bits + rank)
                               : MM_DAG_WORD(at + (halfword >> 1)) >> 16u * (halfword & 1u) & 0xffffu;
  }
  return mm_dag_packed(dag.tiles + 2u * bits * value, bits, index & 63u);
}

#endif
