#include "proofs/tree/subject.hpp"

#include <stdexcept>

#include "impl/tree/container.hpp"
#include "impl/tree/stream.hpp"
#include "impl/tree/tree.hpp"
#include "proofs/index/exact_float.hpp"

namespace mmverify::proofs::tree {
namespace {

namespace fast = impl::tree;

[[noreturn]] void no_entry() { throw std::logic_error("a tree subject was asked for what it has not"); }

fast::Format fast_bits(Format f) { return static_cast<fast::Format>(bits(f)); }

Bytes empty_map(Level n, Format f) {
  return Bytes(spec::micromap::packed_bytes(spec::micromap::micro_triangles(n), f), 0);
}

// ---------------------------------------------------------------------------------------------------------------------
// The specification
// ---------------------------------------------------------------------------------------------------------------------

class SpecifiedCode : public Code {
 public:
  SpecifiedCode(spec::tree::Succinct tree, Level n, Format f) : tree_(std::move(tree)), n_(n), format_(f) {}
  Bytes decode() const override {
    return spec::micromap::pack(spec::tree::decode(tree_, n_, format_).value(), format_);
  }
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    for (std::size_t k = 0; k < index.size(); ++k)
      state[k] = spec::micromap::code(spec::tree::at_index(tree_, n_, index[k]).state);
  }
  void lookup(std::span<const float> u, std::span<const float> v,
              std::span<std::uint8_t> state) const override {
    for (std::size_t k = 0; k < u.size(); ++k)
      state[k] = index::on_exact(u[k], v[k], [&](const auto& p) {
        return spec::micromap::code(spec::tree::at_point(tree_, p).state);
      });
  }
  Bytes bytes() const override { return spec::tree::bytes(tree_, format_); }
  std::uint64_t tree_bits_read(std::uint64_t index) const override {
    return spec::tree::at_index(tree_, n_, index).tree_bits;
  }

 private:
  spec::tree::Succinct tree_;
  Level n_;
  Format format_;
};

class Specified : public TreeSubject {
 public:
  Specified() : TreeSubject("tree-spec", "Algorithms 1, 2 and 3 as printed") {}
  bool has(Entry) const override { return true; }
  CodePtr encode(const Map& map) const override {
    const States states =
        spec::micromap::unpack(map.packed, map.format, spec::micromap::micro_triangles(map.level));
    return std::make_unique<SpecifiedCode>(spec::tree::encode(states, map.level), map.level, map.format);
  }
  CodePtr open(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    auto tree = spec::tree::from_bytes(bytes, f);
    if (!tree || !spec::tree::decode(*tree, n, f)) return nullptr;
    return std::make_unique<SpecifiedCode>(std::move(*tree), n, f);
  }
};

// ---------------------------------------------------------------------------------------------------------------------
// The paper's streams, fast
// ---------------------------------------------------------------------------------------------------------------------

class StreamCode : public Code {
 public:
  StreamCode(fast::Stream stream, Level n, Format f) : stream_(std::move(stream)), n_(n), format_(f) {}
  Bytes decode() const override {
    Bytes map = empty_map(n_, format_);
    if (!fast::decode_stream(n_, fast_bits(format_), stream_, map))
      throw SubjectBroken("refuses what it encoded");
    return map;
  }
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    for (std::size_t k = 0; k < index.size(); ++k)
      state[k] = fast::lookup_stream(n_, fast_bits(format_), stream_, index[k]);
  }
  Bytes bytes() const override {
    Bytes all = stream_.tree;
    all.insert(all.end(), stream_.data.begin(), stream_.data.end());
    return all;
  }

 private:
  fast::Stream stream_;
  Level n_;
  Format format_;
};

class Streamed : public TreeSubject {
 public:
  Streamed() : TreeSubject("tree-stream", "this project's library, the paper's two bit sequences") {}
  bool has(Entry e) const override { return e != Entry::point && e != Entry::reads; }
  CodePtr encode(const Map& map) const override {
    return std::make_unique<StreamCode>(fast::encode_stream(map.level, fast_bits(map.format), map.packed),
                                        map.level, map.format);
  }
  CodePtr open(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    const fast::Stream stream = cut(bytes);
    Bytes map = empty_map(n, f);
    if (!fast::decode_stream(n, fast_bits(f), stream, map)) return nullptr;
    return std::make_unique<StreamCode>(stream, n, f);
  }

 private:
  /// The two sequences: the tree ends where no more nodes are owed, or with the bytes.
  static fast::Stream cut(std::span<const std::uint8_t> bytes) {
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
};

// ---------------------------------------------------------------------------------------------------------------------
// The form for random access
// ---------------------------------------------------------------------------------------------------------------------

class RankedCode : public Code {
 public:
  explicit RankedCode(fast::Tree tree) : tree_(std::move(tree)) {}
  Bytes decode() const override {
    Bytes map = empty_map(tree_.level(), static_cast<Format>(tree_.format()));
    tree_.decode(map);
    return map;
  }
  /// One at a time and all at once must be the same.
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    tree_.lookup(index, state);
    for (std::size_t k = 0; k < index.size(); ++k)
      if (tree_[index[k]] != state[k]) throw SubjectBroken("answers otherwise in a batch");
  }
  void lookup(std::span<const float> u, std::span<const float> v,
              std::span<std::uint8_t> state) const override {
    for (std::size_t k = 0; k < u.size(); ++k) state[k] = tree_.at(u[k], v[k]);
  }

 protected:
  const fast::Tree& tree() const { return tree_; }

 private:
  fast::Tree tree_;
};

class Ranked : public TreeSubject {
 public:
  explicit Ranked(std::string name = "tree-ranked",
                  std::string about = "this project's library, its form for random access")
      : TreeSubject(std::move(name), std::move(about)) {}
  bool has(Entry e) const override { return e == Entry::lookup || e == Entry::point; }
  CodePtr encode(const Map& map) const override {
    return std::make_unique<RankedCode>(fast::Tree::encode(map.level, fast_bits(map.format), map.packed));
  }
};

/// A form with steps from the root to the last level, and the one that the library chooses.
class StepwiseCode : public RankedCode {
 public:
  StepwiseCode(fast::Tree tree, fast::Tree usual) : RankedCode(std::move(tree)), usual_(std::move(usual)) {}
  /// In both at once, turn by turn, besides: lookups in many trees take steps of their own.
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    RankedCode::lookup(index, state);
    const fast::Tree* const both[] = {&tree(), &usual_};
    std::vector<std::uint32_t> which(index.size());
    for (std::size_t k = 0; k < which.size(); ++k) which[k] = k % 3 % 2;
    std::vector<std::uint8_t> again(state.size());
    fast::lookup(both, which, index, again);
    if (!std::equal(again.begin(), again.end(), state.begin()))
      throw SubjectBroken("answers otherwise among other trees");
  }
  using RankedCode::lookup;

 private:
  fast::Tree usual_;
};

/// Where the library would lay small maps flat, it steps.
class Stepwise : public Ranked {
 public:
  Stepwise()
      : Ranked("tree-stepwise", "this project's library, its form for random access with no flat part") {}
  CodePtr encode(const Map& map) const override {
    const auto bits = fast_bits(map.format);
    return std::make_unique<StepwiseCode>(
        fast::Tree::encode(map.level, bits, map.packed, {0, std::max<Level>(map.level, 1) - 1}),
        fast::Tree::encode(map.level, bits, map.packed));
  }
};

// ---------------------------------------------------------------------------------------------------------------------
// The container
// ---------------------------------------------------------------------------------------------------------------------

class ContainerCode : public Code {
 public:
  ContainerCode(Bytes bytes, Level n, Format f) : bytes_(std::move(bytes)), n_(n), format_(f) {}
  Bytes decode() const override {
    const fast::Contents contents = fast::read(bytes_);
    if (contents.level != n_ || static_cast<Format>(contents.format) != format_)
      throw SubjectBroken("holds another level or format");
    return contents.map;
  }
  Bytes bytes() const override { return bytes_; }

 private:
  Bytes bytes_;
  Level n_;
  Format format_;
};

class Contained : public TreeSubject {
 public:
  Contained() : TreeSubject("tree-container", "this project's library, its serialised form") {}
  bool has(Entry e) const override { return e == Entry::bytes; }
  CodePtr encode(const Map& map) const override {
    return std::make_unique<ContainerCode>(fast::write(map.level, fast_bits(map.format), map.packed),
                                           map.level, map.format);
  }
  CodePtr open(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    const auto contents = fast::try_read(bytes);
    if (!contents || contents->level != n || static_cast<Format>(contents->format) != f) return nullptr;
    return std::make_unique<ContainerCode>(Bytes(bytes.begin(), bytes.end()), n, f);
  }
};

}  // namespace

void Code::lookup(std::span<const std::uint32_t>, std::span<std::uint8_t>) const { no_entry(); }
void Code::lookup(std::span<const float>, std::span<const float>, std::span<std::uint8_t>) const {
  no_entry();
}
Bytes Code::bytes() const { no_entry(); }
std::uint64_t Code::tree_bits_read(std::uint64_t) const { no_entry(); }
CodePtr TreeSubject::open(Level, Format, std::span<const std::uint8_t>) const { no_entry(); }

const std::vector<TreeSubjectPtr>& built_in_subjects() {
  static const std::vector<TreeSubjectPtr> all{std::make_shared<Specified>(), std::make_shared<Streamed>(),
                                               std::make_shared<Ranked>(), std::make_shared<Stepwise>(),
                                               std::make_shared<Contained>()};
  return all;
}

TreeSubjectPtr built_in(const std::string& name) {
  for (const TreeSubjectPtr& s : built_in_subjects())
    if (s->name() == name) return s;
  throw std::logic_error("no built-in tree subject " + name);
}

}  // namespace mmverify::proofs::tree
