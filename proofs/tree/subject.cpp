#include "proofs/tree/subject.hpp"

#include "impl/tree/container.hpp"
#include "impl/tree/tree.hpp"
#include "proofs/points/exact_float.hpp"

namespace mmverify::proofs::tree {
namespace {

namespace fast = impl::tree;

fast::Format fast_bits(Format f) { return static_cast<fast::Format>(bits(f)); }

Bytes empty_map(Level n, Format f) {
  return Bytes(spec::micromap::packed_bytes(spec::micromap::micro_triangles(n), f), 0);
}

// ---- The specification

Functions specified() {
  using spec::tree::Succinct;
  Functions s;
  s.encode = [](const Map& map) {
    const States states =
        spec::micromap::unpack(map.packed, map.format, spec::micromap::micro_triangles(map.level));
    return coded(map.level, map.format, spec::tree::encode(states, map.level));
  };
  s.decode = [](const Code& c) {
    return spec::micromap::pack(spec::tree::decode(form_of<Succinct>(c), c.level, c.format).value(),
                                c.format);
  };
  s.lookup = [](const Code& c, std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < index.size(); ++k)
      state[k] = spec::micromap::code(spec::tree::at_index(form_of<Succinct>(c), c.level, index[k]).state);
  };
  s.point = [](const Code& c, std::span<const float> u, std::span<const float> v,
               std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < u.size(); ++k)
      state[k] = points::on_exact(u[k], v[k], [&](const auto& p) {
        return spec::micromap::code(spec::tree::at_point(form_of<Succinct>(c), p).state);
      });
  };
  s.bytes = [](const Code& c) { return spec::tree::bytes(form_of<Succinct>(c), c.format); };
  s.open = [](Level n, Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
    auto tree = spec::tree::from_bytes(bytes, f);
    if (!tree || !spec::tree::decode(*tree, n, f)) return std::nullopt;
    return coded(n, f, std::move(*tree));
  };
  s.tree_bits_read = [](const Code& c, std::uint64_t index) -> std::uint64_t {
    return spec::tree::at_index(form_of<Succinct>(c), c.level, index).tree_bits;
  };
  s.writes_paper = s.reads_paper = true;
  return s;
}

// ---- The paper's streams, fast

/// The two sequences: the tree ends once every node has its children, or with the bytes.
fast::Stream cut(std::span<const std::uint8_t> bytes) {
  fast::Stream s;
  for (std::uint64_t owed = 1; owed > 0 && s.nodes / 8 < bytes.size(); ++s.nodes) {
    const bool internal = (bytes[s.nodes / 8] >> s.nodes % 8 & 1) != 0;
    owed = internal ? owed + 3 : owed - 1;
    s.leaves += internal ? 0 : 1;
  }
  const std::size_t tree_bytes = (s.nodes + 7) / 8;
  s.tree.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(tree_bytes));
  s.data.assign(bytes.begin() + static_cast<std::ptrdiff_t>(tree_bytes), bytes.end());
  return s;
}

Functions streamed() {
  using fast::Stream;
  Functions s;
  s.encode = [](const Map& map) {
    return coded(map.level, map.format, fast::encode_stream(map.level, fast_bits(map.format), map.packed));
  };
  s.decode = [](const Code& c) {
    Bytes map = empty_map(c.level, c.format);
    if (!fast::decode_stream(c.level, fast_bits(c.format), form_of<Stream>(c), map))
      throw SubjectBroken("refuses what it encoded");
    return map;
  };
  s.lookup = [](const Code& c, std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < index.size(); ++k)
      state[k] = fast::lookup_stream(c.level, fast_bits(c.format), form_of<Stream>(c), index[k]);
  };
  s.bytes = [](const Code& c) {
    const auto& stream = form_of<Stream>(c);
    Bytes all = stream.tree;
    all.insert(all.end(), stream.data.begin(), stream.data.end());
    return all;
  };
  s.open = [](Level n, Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
    Stream stream = cut(bytes);
    Bytes map = empty_map(n, f);
    if (!fast::decode_stream(n, fast_bits(f), stream, map)) return std::nullopt;
    return coded(n, f, std::move(stream));
  };
  s.writes_paper = s.reads_paper = true;
  return s;
}

// ---- The form for random access

/// The functions on a code's tree; tree_of(code) gives the tree.
template <class TreeOf>
Functions of_trees(TreeOf tree_of) {
  Functions s;
  s.decode = [tree_of](const Code& c) {
    Bytes map = empty_map(c.level, c.format);
    tree_of(c).decode(map);
    return map;
  };
  // Single lookups and batches must agree.
  s.lookup = [tree_of](const Code& c, std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
    const fast::Tree& tree = tree_of(c);
    tree.lookup(index, state);
    for (std::size_t k = 0; k < index.size(); ++k)
      if (tree[index[k]] != state[k]) throw SubjectBroken("answers otherwise in a batch");
  };
  s.point = [tree_of](const Code& c, std::span<const float> u, std::span<const float> v,
                      std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < u.size(); ++k) state[k] = tree_of(c).at(u[k], v[k]);
  };
  return s;
}

Functions ranked() {
  Functions s = of_trees([](const Code& c) -> const fast::Tree& { return form_of<fast::Tree>(c); });
  s.encode = [](const Map& map) {
    return coded(map.level, map.format, fast::Tree::encode(map.level, fast_bits(map.format), map.packed));
  };
  return s;
}

/// A tree with steps from the root to the last level, and the tree that the library chooses.
struct Stepwise {
  fast::Tree tree, usual;
};

/// A subject whose trees have steps even for small maps, which the library would lay flat.
Functions stepwise() {
  Functions s = of_trees([](const Code& c) -> const fast::Tree& { return form_of<Stepwise>(c).tree; });
  s.encode = [](const Map& map) {
    const auto bits = fast_bits(map.format);
    return coded(
        map.level, map.format,
        Stepwise{fast::Tree::encode(map.level, bits, map.packed, {0, std::max<Level>(map.level, 1) - 1}),
                 fast::Tree::encode(map.level, bits, map.packed)});
  };
  // Also looks up in both trees by turns: lookups in many trees take steps of their own.
  s.lookup = [in_one = s.lookup](const Code& c, std::span<const std::uint32_t> index,
                                 std::span<std::uint8_t> state) {
    in_one(c, index, state);
    const auto& [tree, usual] = form_of<Stepwise>(c);
    const fast::Tree* const both[] = {&tree, &usual};
    std::vector<std::uint32_t> which(index.size());
    for (std::size_t k = 0; k < which.size(); ++k) which[k] = k % 3 % 2;
    std::vector<std::uint8_t> again(state.size());
    fast::lookup(both, which, index, again);
    if (!std::equal(again.begin(), again.end(), state.begin()))
      throw SubjectBroken("answers otherwise among other trees");
  };
  return s;
}

// ---- The container

Functions contained() {
  Functions s;
  s.encode = [](const Map& map) {
    return coded(map.level, map.format, fast::write(map.level, fast_bits(map.format), map.packed));
  };
  s.decode = [](const Code& c) {
    const fast::Contents contents = fast::read(form_of<Bytes>(c));
    if (contents.level != c.level || static_cast<Format>(contents.format) != c.format)
      throw SubjectBroken("holds another level or format");
    return contents.map;
  };
  s.bytes = [](const Code& c) { return form_of<Bytes>(c); };
  s.open = [](Level n, Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
    const auto contents = fast::try_read(bytes);
    if (!contents || contents->level != n || static_cast<Format>(contents->format) != f) return std::nullopt;
    return coded(n, f, Bytes(bytes.begin(), bytes.end()));
  };
  return s;
}

TreeSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<TreeSubject>(name, about, std::move(functions));
}

}  // namespace

const std::vector<TreeSubjectPtr>& built_in_subjects() {
  static const std::vector<TreeSubjectPtr> all{
      subject("tree-spec", "Algorithms 1, 2 and 3 as printed", specified()),
      subject("tree-stream", "this project's library, the paper's two bit sequences", streamed()),
      subject("tree-ranked", "this project's library, its form for random access", ranked()),
      subject("tree-stepwise", "this project's library, its form for random access with no flat part",
              stepwise()),
      subject("tree-container", "this project's library, its serialised form", contained())};
  return all;
}

}  // namespace mmverify::proofs::tree
