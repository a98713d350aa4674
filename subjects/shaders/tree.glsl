// States out of trees: the paper's two bit sequences, and the form with counts.
//
// Before the include MM_TREE_WORD(k) has to be defined: word k of the code, four bytes, the first the lowest.
#ifndef MMVERIFY_SHADERS_TREE
#define MMVERIFY_SHADERS_TREE

// ---- the paper's sequences: the tree's bits in pre-order, 1 internal and 0 leaf; the leaves' states ----

uint mm_tree_bit(uint t) { return MM_TREE_WORD(t >> 5) >> (t & 31u) & 1u; }

/// A place in the two sequences: bit t of the tree, value d of the leaves.
struct MmCursor {
  uint t, d;
};

/// Passes over `subtrees` whole subtrees from a place on; `end` bounds the reading where the bits are no tree.
/// A 1 opens four subtrees in the place of one, a 0 is one; 32 bits at a time where they cannot be the last.
/// Source: Succinct Opacity Micromaps, 4.2, Algorithm 3, bitscan.
MmCursor mm_tree_pass(MmCursor at, uint subtrees, uint end) {
  while (subtrees > 0u && at.t < end) {
    if ((at.t & 31u) == 0u && subtrees > 32u && at.t + 32u <= end) {
      uint ones = uint(bitCount(MM_TREE_WORD(at.t >> 5)));
      subtrees += 4u * ones - 32u;
      at.d += 32u - ones;
      at.t += 32u;
      continue;
    }
    uint internal = mm_tree_bit(at.t);
    subtrees += 4u * internal;
    --subtrees;
    at.d += 1u - internal;
    ++at.t;
  }
  return at;
}

/// How many bits the tree has.  Whoever keeps codes keeps this beside each: it is where the states begin, at the next whole
/// byte.  Domain: `end` bits can be read.
uint mm_tree_bits(uint end) { return mm_tree_pass(MmCursor(0u, 0u), 1u, end).t; }

/// The state at an index: down the tree by the index's digits, the subtrees before each child passed over.
/// Domain: index < 4^level, a code of `bits` (1 or 2) a state whose tree has tree_bits.
/// Source: Succinct Opacity Micromaps, 4.2, Algorithm 3, tree-lookup.
uint mm_tree_lookup(uint level, uint bits, uint index, uint tree_bits) {
  MmCursor at = MmCursor(0u, 0u);
  for (uint depth = level; depth > 0u && mm_tree_bit(at.t) != 0u; --depth) {
    ++at.t;
    at = mm_tree_pass(at, index >> 2u * (depth - 1u) & 3u, tree_bits);
  }
  uint place = (tree_bits + 7u & ~7u) + at.d * bits;
  return MM_TREE_WORD(place >> 5) >> (place & 31u) & ((1u << bits) - 1u);
}

// ---- the form with counts: impl/tree/tree.hpp ----

/// Of 32 bits the lowest `count`.
uint mm_low_bits(uint count) { return count >= 32u ? ~0u : (1u << count) - 1u; }

/// A node of it: whether it is internal, and how many internal ones there are up to it, itself included.
struct MmRank {
  uint internal, ones;
};

/// Node p of the words from word 2 on: each has 64 bits, `per_word` nodes and above them the ones of all words before.
MmRank mm_tree_rank(uint p, uint per_word) {
  uint w = p / per_word, at = p - w * per_word;
  uint low = MM_TREE_WORD(2u + 2u * w), high = MM_TREE_WORD(3u + 2u * w);
  uint before = high >> (per_word - 32u);
  uint internal = (at < 32u ? low >> at : high >> (at - 32u)) & 1u;
  uint ones = uint(bitCount(low & mm_low_bits(at + 1u)));
  if (at >= 32u) ones += uint(bitCount(high & mm_low_bits(at - 31u)));
  return MmRank(internal, before + ones);
}

/// The state at an index: one load of 64 bits a step, no walking over subtrees.
///   children of internal node number r (from 0): 4^k + 4 r on;  leaf at p: value p - (ones before p)
/// Domain: index < 4^level; a form of mmverify::impl::tree::Tree::encode.
uint mm_ranked_lookup(uint index) {
  uint header = MM_TREE_WORD(0), header_high = MM_TREE_WORD(1);
  uint log_b = header & 1u, count_size = header >> 1 & 3u;
  // Even numbers, stored in halves.
  uint top = header >> 2 & 30u, below_top = header >> 6 & 30u, in_block = header >> 10 & 30u;
  uint parents = (header >> 15 | header_high << 17) & 0x1fffffu, blocks = header_high >> 4;
  uint per_word = 56u - 8u * count_size;
  uint p = index >> below_top;
  MmRank at = mm_tree_rank(p, per_word);
  for (uint shift = below_top; shift > in_block && at.internal != 0u;) {
    shift -= 2u;
    p = (1u << top) + 4u * (at.ones - 1u) + (index >> shift & 3u);
    at = mm_tree_rank(p, per_word);
  }
  uint nodes = (1u << top) + 4u * parents;
  uint states_at = 64u + (nodes + per_word - 1u) / per_word * 64u;
  uint value = at.internal != 0u ? ((at.ones - 1u - parents) << in_block) + (index & mm_low_bits(in_block))
                                 : (blocks << in_block) + p - at.ones;
  uint place = states_at + (value << log_b);
  return MM_TREE_WORD(place >> 5) >> (place & 31u) & (2u * log_b + 1u);
}

#endif
