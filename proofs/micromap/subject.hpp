// An implementation of topic micromap in the dock, and what it may be asked: bytes in, bytes out.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/entries.hpp"
#include "spec/micromap/level.hpp"
#include "spec/micromap/validate.hpp"

namespace mmverify::proofs::micromap {

using spec::micromap::Bytes;
using spec::micromap::Encoding;
using spec::micromap::Format;
using spec::micromap::Input;
using spec::micromap::Meaning;
using spec::micromap::Mode;
using spec::micromap::Options;
using spec::micromap::State;
using spec::micromap::States;
using spec::micromap::UsageCount;
using spec::micromap::Violation;

/// What a subject may be asked.
/// pack: states to bytes and back; force2: 4-state to 2-state and back; up, down: one level; modes: through a
/// 1-bit mode and back; special: special indices; substitute: what a lossy codec makes of a map; judge: what a
/// substitution keeps; build: arrays; validate: violations.
#define MMVERIFY_MICROMAP_ENTRIES(ROW) \
  ROW(pack, "pack")                    \
  ROW(force2, "force2")                \
  ROW(up, "up")                        \
  ROW(down, "down")                    \
  ROW(modes, "modes")                  \
  ROW(special, "special")              \
  ROW(substitute, "substitute")        \
  ROW(judge, "judge")                  \
  ROW(build, "build")                  \
  ROW(validate, "validate")
MMVERIFY_ENTRIES(MMVERIFY_MICROMAP_ENTRIES)

/// A map, packed: 4^n states of the format.
struct PackedMap {
  Level level = 0;
  Format format = Format::four_state;
  Bytes bytes;
};

/// What a subject builds of a geometry's maps.
struct Built {
  Bytes records, data, indices;
  std::vector<UsageCount> array_counts, geometry_counts;
};

/// Which of the three rules of lossy substitution hold between two maps.
struct Kept {
  bool allowed = false, conservative = false, force2_stable = false;
  friend bool operator==(const Kept&, const Kept&) = default;
};

/// Every call is const and may come from several threads at once.  Packed bytes are LSB first; a subject gets
/// padding bits of any value and gives zeros.  Level and format are those of the input.
class MicromapSubject : public Subject {
 public:
  MicromapSubject(std::string name, std::string about)
      : Subject("micromap", std::move(name), std::move(about)) {}
  /// Maps have no points between theirs.
  bool exact() const override { return true; }
  virtual bool has(Entry e) const = 0;

  virtual Bytes pack(Format f, const States& states) const;
  virtual States unpack(Format f, std::uint64_t count, std::span<const std::uint8_t> bytes) const;
  virtual Bytes force2(Level n, std::span<const std::uint8_t> four_state) const;
  virtual Bytes widen(Level n, std::span<const std::uint8_t> two_state) const;
  virtual Bytes up(Level n, Format f, std::span<const std::uint8_t> bytes) const;
  virtual Bytes down(Level n, Format f, std::span<const std::uint8_t> bytes) const;
  virtual Bytes through(Level n, Mode mode, std::span<const std::uint8_t> four_state) const;
  virtual std::uint32_t special_code(State s, Encoding e) const;
  virtual Meaning meaning(std::uint32_t code, Encoding e) const;
  virtual Bytes substitute(Level n, std::span<const std::uint8_t> four_state) const;
  virtual Kept judge(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) const;
  /// Appends to an array in which every map of `before` has a record of its own.
  virtual Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps,
                      const Options& options) const;
  virtual std::vector<Violation> validate(const Input& in) const;
};
using MicromapSubjectPtr = std::shared_ptr<const MicromapSubject>;

/// micromap-spec, micromap, and three lossy codecs: lossy-stable, lossy-conservative, lossy-merge.
const std::vector<MicromapSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
MicromapSubjectPtr the(const std::string& name);

}  // namespace mmverify::proofs::micromap
