// An implementation of topic tree in the dock: who encodes maps, gives states back, and reads others' bytes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/entries.hpp"
#include "spec/tree/tree.hpp"

namespace mmverify::proofs::tree {

using spec::micromap::bits;
using spec::micromap::Bytes;
using spec::micromap::Format;
using spec::micromap::State;
using spec::micromap::States;

/// A map, packed: 4^n states of the format.
struct Map {
  Level level = 0;
  Format format = Format::two_state;
  Bytes packed;
};

/// What a subject may be asked beside encoding a map and decoding it.
/// bytes: its codes as bytes, and codes from bytes; stream: the bytes that it writes are the paper's,
/// spec::tree::bytes; paper: the bytes that it reads are; reads: how many of the tree's bits a lookup reads.
#define MMVERIFY_TREE_ENTRIES(ROW)     \
  ROW(lookup, "index -> state")        \
  ROW(point, "barycentrics -> state")  \
  ROW(bytes, "bytes")                  \
  ROW(stream, "the paper's bytes")     \
  ROW(paper, "the paper's codes read") \
  ROW(reads, "bits read")
MMVERIFY_ENTRIES(MMVERIFY_TREE_ENTRIES)

/// An encoded map.  Const calls may come from several threads at once.
class Code {
 public:
  virtual ~Code() = default;
  virtual Bytes decode() const = 0;
  /// One state an index below 4^n.
  virtual void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const;
  /// One state a pair of barycentrics.
  virtual void lookup(std::span<const float> u, std::span<const float> v,
                      std::span<std::uint8_t> state) const;
  virtual Bytes bytes() const;
  virtual std::uint64_t tree_bits_read(std::uint64_t index) const;
};
using CodePtr = std::unique_ptr<const Code>;

class TreeSubject : public Subject {
 public:
  TreeSubject(std::string name, std::string about) : Subject("tree", std::move(name), std::move(about)) {}
  /// Codes and indices stand for themselves; barycentrics come as floats, whose index is found anew each time.
  bool exact() const override { return !has(Entry::point); }
  virtual bool has(Entry e) const = 0;
  virtual Level max_level() const { return 12; }
  virtual CodePtr encode(const Map& map) const = 0;
  /// Null where the bytes are refused.
  virtual CodePtr open(Level n, Format f, std::span<const std::uint8_t> bytes) const;
};

using TreeSubjectPtr = std::shared_ptr<const TreeSubject>;

/// tree-spec, tree-stream, tree-ranked, tree-stepwise, tree-container.
const std::vector<TreeSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
TreeSubjectPtr built_in(const std::string& name);

}  // namespace mmverify::proofs::tree
