#include "proofs/tree/damages.hpp"

#include <set>

#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::tree {
namespace {

using spec::micromap::micro_triangles;
using spec::tree::Succinct;

void flip(Bytes& bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
}

/// A subtree by its place in the two sequences and in the map.
struct Subtree {
  Level depth;
  std::uint64_t node;              ///< its number among those of its depth
  std::size_t t, t_end, d, d_end;  ///< nodes [t, t_end), leaves [d, d_end)
  bool leaf() const { return t + 1 == t_end; }
};

/// All subtrees of a tree, in pre-order.
std::vector<Subtree> subtrees(const Succinct& s) {
  std::vector<Subtree> all;
  std::size_t d = 0;
  const auto visit = [&](const auto& self, Level depth, std::uint64_t node) -> void {
    const std::size_t me = all.size();
    all.push_back({depth, node, me, 0, d, 0});
    if (s.tree[me])
      for (std::uint64_t child = 0; child < 4; ++child) self(self, depth + 1, 4 * node + child);
    else
      ++d;
    all[me].t_end = all.size();
    all[me].d_end = d;
  };
  visit(visit, 0, 0);
  return all;
}

/// The sequences with the subtree `at` replaced by `by`.
Succinct replaced(const Succinct& s, const Subtree& at, const Succinct& by) {
  Succinct out;
  const auto add = [&](const Succinct& from, std::size_t t, std::size_t t_end, std::size_t d,
                       std::size_t d_end) {
    for (; t < t_end; ++t) out.tree.push_back(from.tree[t]);
    for (; d < d_end; ++d) out.data.push_back(from.data[d]);
  };
  add(s, 0, at.t, 0, at.d);
  add(by, 0, by.tree.size(), 0, by.data.size());
  add(s, at.t_end, s.tree.size(), at.d_end, s.data.size());
  return out;
}

Succinct part(const Succinct& s, const Subtree& at) {
  const auto begin = s.tree.begin() + static_cast<std::ptrdiff_t>(at.t);
  const auto end = s.tree.begin() + static_cast<std::ptrdiff_t>(at.t_end);
  return {{begin, end},
          {s.data.begin() + static_cast<std::ptrdiff_t>(at.d),
           s.data.begin() + static_cast<std::ptrdiff_t>(at.d_end)}};
}

/// A node with four children.
Succinct node_of(std::initializer_list<const Succinct*> children) {
  Succinct out;
  out.tree.push_back(true);
  for (const Succinct* child : children) {
    out.tree.insert(out.tree.end(), child->tree.begin(), child->tree.end());
    out.data.insert(out.data.end(), child->data.begin(), child->data.end());
  }
  return out;
}

/// A leaf that is split `times` times into four equal ones; each time all of them are split, or only the first.
Succinct split(State state, Level times, bool all) {
  const Succinct leaf{{false}, {state}};
  Succinct out = leaf;
  for (; times > 0; --times)
    out = all ? node_of({&out, &out, &out, &out}) : node_of({&out, &leaf, &leaf, &leaf});
  return out;
}

void set_state(Map& map, std::uint64_t k, std::uint8_t state) {
  const unsigned b = bits(map.format);
  auto& byte = map.packed[k * b / 8];
  const unsigned shift = static_cast<unsigned>(k * b % 8);
  byte = static_cast<std::uint8_t>((byte & ~(((1u << b) - 1) << shift)) | unsigned{state} << shift);
}

/// The number of states of a node.
std::uint64_t run_of(Level n, Level depth) { return micro_triangles(n - depth); }

/// Codes that are made of the subtrees of one map's code, until `take` wants no more.
class Construction {
 public:
  Construction(const Map& map, const std::function<bool(const Constructed&)>& take)
      : map_(map), take_(take) {}

  void give_all() {
    // Any leaf, any internal node and any node of four leaves, for each depth.
    std::vector<const Subtree*> leaves(n_ + 1), internals(n_ + 1), last_internals(n_ + 1);
    std::vector<std::uint64_t> seen(3 * (n_ + 1));
    for (const Subtree& x : all_) {
      const auto choose = [&](std::vector<const Subtree*>& among, std::size_t kind) {
        if (random_.below(++seen[kind * (n_ + 1) + x.depth]) == 0) among[x.depth] = &x;
      };
      choose(x.leaf() ? leaves : internals, x.leaf() ? 0 : 1);
      if (!x.leaf() && x.t_end == x.t + 5) choose(last_internals, 2);
    }
    for (const Subtree* x : leaves)
      if (x != nullptr) {
        split_leaf(*x);
        change_leaf(*x);
      }
    for (const Subtree* x : internals)
      if (x != nullptr) {
        exchange_children(*x);
        if (x->depth == 1) give_quarter(*x);
      }
    for (const Subtree* x : last_internals)
      if (x != nullptr) make_alike(*x);
    if (std::any_of(all_.begin(), all_.end(), [&](const Subtree& x) { return x.leaf() && x.depth < n_; }))
      split_all();
    damage_ends();
  }

 private:
  Bytes bytes_of(const Succinct& sequences) const { return spec::tree::bytes(sequences, map_.format); }
  void give(const std::string& what, Bytes bytes, std::optional<Map> meant = std::nullopt) {
    if (go_on_) go_on_ = take_({{what, n_, map_.format, std::move(bytes)}, std::move(meant)});
  }
  static std::string at(const Subtree& x) { return fmt::format("node {} of depth {}", x.node, x.depth); }

  void split_leaf(const Subtree& x) {
    const State state = s_.data[x.d];
    const auto four_for_one = [&](const char* what, Level times, bool everywhere) {
      give(fmt::format("{} {},", at(x), what), bytes_of(replaced(s_, x, split(state, times, everywhere))));
    };
    // Four children of a leaf at the last level lie below it.
    four_for_one("is four equal leaves", 1, true);
    if (x.depth + 1 < n_)
      four_for_one("is equal leaves down to the last level on one way", n_ - x.depth, false);
    if (x.depth + 2 < n_) four_for_one("is sixteen equal leaves", 2, true);
    four_for_one("goes below the last level", n_ - x.depth + 1, false);
  }
  /// The leaf with another state; that is a code unless it then equals its siblings.
  void change_leaf(const Subtree& x) {
    const State state = s_.data[x.d];
    const auto other =
        static_cast<State>((spec::micromap::code(state) + 1 + random_.below((1u << bits(map_.format)) - 1)) %
                           (1u << bits(map_.format)));
    Map changed = map_;
    const std::uint64_t run = run_of(n_, x.depth);
    for (std::uint64_t k = x.node * run; k < (x.node + 1) * run; ++k)
      set_state(changed, k, spec::micromap::code(other));
    bool alike = x.depth > 0;
    const std::uint64_t parent = x.node / 4 * 4 * run;
    for (std::uint64_t k = parent; alike && k < parent + 4 * run; ++k)
      alike = state_at(changed, k) == spec::micromap::code(other);
    give(fmt::format("{} has another state,", at(x)), bytes_of(replaced(s_, x, {{false}, {other}})),
         alike ? std::nullopt : std::optional(changed));
  }
  void exchange_children(const Subtree& x) {
    std::vector<const Subtree*> children;
    for (std::size_t t = x.t + 1; t < x.t_end; t = all_[t].t_end) children.push_back(&all_[t]);
    const std::size_t a = random_.below(3), b = a + 1 + random_.below(3 - a);
    std::swap(children[a], children[b]);
    const Succinct parts[] = {part(s_, *children[0]), part(s_, *children[1]), part(s_, *children[2]),
                              part(s_, *children[3])};
    Map exchanged = map_;
    const std::uint64_t run = run_of(n_, x.depth + 1);
    for (std::uint64_t k = 0; k < run; ++k) {
      set_state(exchanged, (4 * x.node + a) * run + k, state_at(map_, (4 * x.node + b) * run + k));
      set_state(exchanged, (4 * x.node + b) * run + k, state_at(map_, (4 * x.node + a) * run + k));
    }
    give(fmt::format("children {} and {} of {} exchanged,", a, b, at(x)),
         bytes_of(replaced(s_, x, node_of({&parts[0], &parts[1], &parts[2], &parts[3]}))), exchanged);
  }
  /// A quarter alone: each of its micro-triangles becomes four times as large.
  void give_quarter(const Subtree& x) {
    Map alone{n_, map_.format, Bytes(map_.packed.size(), 0)};
    for (std::uint64_t k = 0; k < micro_triangles(n_); ++k)
      set_state(alone, k, state_at(map_, x.node * run_of(n_, 1) + k / 4));
    give(fmt::format("{} alone,", at(x)), bytes_of(part(s_, x)), alone);
  }
  void make_alike(const Subtree& x) {
    Succinct alike = s_;
    for (std::size_t d = x.d; d < x.d_end; ++d) alike.data[d] = s_.data[x.d];
    give(fmt::format("four alike below {},", at(x)), bytes_of(alike));
  }
  /// All leaves split down to the last level.
  void split_all() {
    Succinct perfect;
    for (const Subtree& x : all_) {
      if (!x.leaf()) {
        perfect.tree.push_back(true);
        continue;
      }
      const Succinct whole = split(s_.data[x.d], n_ - x.depth, true);
      perfect.tree.insert(perfect.tree.end(), whole.tree.begin(), whole.tree.end());
      perfect.data.insert(perfect.data.end(), whole.data.begin(), whole.data.end());
    }
    give("no siblings merged,", bytes_of(perfect));
  }
  /// Padding bits set, a byte between the sequences, and the tree alone.
  void damage_ends() {
    const Bytes code = bytes_of(s_);
    const std::size_t tree_bytes = (s_.tree.size() + 7) / 8, tree_end = s_.tree.size(),
                      data_end = 8 * tree_bytes + bits(map_.format) * s_.data.size();
    const auto set_padding = [&](std::size_t bit, std::size_t end) {
      for (; bit < end; ++bit) {
        Bytes padded = code;
        flip(padded, bit);
        give(fmt::format("padding bit {} set,", bit), padded);
      }
    };
    set_padding(tree_end, 8 * tree_bytes);
    set_padding(data_end, 8 * code.size());
    const auto border = static_cast<std::ptrdiff_t>(tree_bytes);
    Bytes gap = code;
    gap.insert(gap.begin() + border, 0);
    give("a byte between the sequences,", gap);
    give("the tree alone,", {code.begin(), code.begin() + border});
  }

  const Map& map_;
  const std::function<bool(const Constructed&)>& take_;
  const Level n_ = map_.level;
  const Succinct s_ =
      spec::tree::encode(spec::micromap::unpack(map_.packed, map_.format, micro_triangles(n_)), n_);
  const std::vector<Subtree> all_ = subtrees(s_);
  Random random_{hash_of(map_.packed), n_, 78};
  bool go_on_ = true;
};

}  // namespace

void any_damage(const Map& map, const Bytes& code, std::size_t thorough, const TakeDamaged& take) {
  const Level n = map.level;
  const Format f = map.format;
  Random random(hash_of(map.packed), n, 77);
  bool go_on = true;
  const auto give = [&](const std::string& what, const Bytes& bytes) {
    go_on = go_on && take({what, n, f, bytes});
  };

  const std::size_t size = code.size(), all_bits = 8 * size;
  std::set<std::size_t> cuts{0, 1, 2, size / 4, size / 2, 3 * size / 4, size - 2, size - 1}, flips;
  if (size <= thorough) {
    for (std::size_t k = 0; k < all_bits; ++k) flips.insert(k);
    for (std::size_t k = 0; k < size; ++k) cuts.insert(k);
  } else {
    for (std::size_t k = 0; k < 8; ++k)
      flips.insert({k, 8 + k, all_bits - 1 - k, random.below(all_bits), random.below(all_bits)});
    cuts.insert({random.below(size), random.below(size)});
  }
  for (const std::size_t cut : cuts)
    if (cut < size)
      give(fmt::format("cut to {} bytes,", cut),
           {code.begin(), code.begin() + static_cast<std::ptrdiff_t>(cut)});

  const std::uint8_t any = static_cast<std::uint8_t>(1 + random.below(255));
  // Some decoders round sizes up.
  const std::set<std::size_t> longer_by{1, 2, 3, 4, 5, 6, 7, 8, 16, 64, 16 - size % 16, 64 - size % 64};
  for (const std::uint8_t value : {std::uint8_t{0}, std::uint8_t{0xFF}, any})
    for (const std::size_t more : longer_by) {
      Bytes longer = code;
      longer.insert(longer.end(), more, value);
      give(fmt::format("{} bytes {:02x} more,", more, value), longer);
    }
  // A count of 8 or 16 bits overflows to 0 with so many bytes more.
  for (const std::size_t more : {std::size_t{1} << 8, std::size_t{1} << 16}) {
    Bytes longer = code;
    longer.insert(longer.end(), more, 0);
    give(fmt::format("{} bytes 00 more,", more), longer);
  }
  // Nodes in nodes, a million deep, against a decoder that descends before it counts.
  give("in the place of all 2^17 bytes ff,", Bytes(std::size_t{1} << 17, 0xFF));
  Bytes twice = code;
  twice.insert(twice.end(), code.begin(), code.end());
  give("twice,", twice);

  Bytes bytes = code;
  for (const std::size_t bit : flips) {
    flip(bytes, bit);
    give(fmt::format("bit {} flipped,", bit), bytes);
    flip(bytes, bit);
  }
  const auto other = [&](Level level, Format format) {
    if (go_on)
      go_on = take({fmt::format("as {}-state of level {},", 1 << bits(format), level), level, format, code});
  };
  if (n > 0) other(n - 1, f);
  if (n < 12) other(n + 1, f);
  other(n, f == Format::two_state ? Format::four_state : Format::two_state);
}

void constructed_codes(const Map& map, const std::function<bool(const Constructed&)>& take) {
  Construction(map, take).give_all();
}

}  // namespace mmverify::proofs::tree
