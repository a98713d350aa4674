// An implementation of topic micromap in the dock, and what it may be asked: bytes in, bytes out.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
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

/// What a subject has; an empty function is an entry point that is missing.  Calls may come from several threads
/// at once.  Packed bytes are LSB first; a subject gets padding bits of any value and gives zeros.  Level and
/// format are those of the input.
struct Functions {
  using Packed = std::span<const std::uint8_t>;
  std::function<Bytes(Format, const States&)> pack = {};
  std::function<States(Format, std::uint64_t count, Packed)> unpack = {};
  std::function<Bytes(Level, Packed four_state)> force2 = {};
  std::function<Bytes(Level, Packed two_state)> widen = {};
  std::function<Bytes(Level, Format, Packed)> up = {}, down = {};
  std::function<Bytes(Level, Mode, Packed four_state)> through = {};
  std::function<std::uint32_t(State, Encoding)> special_code = {};
  std::function<Meaning(std::uint32_t code, Encoding)> meaning = {};
  std::function<Bytes(Level, Packed four_state)> substitute = {};
  std::function<Kept(Level, Packed was, Packed is)> judge = {};
  /// Appends to an array in which every map of `before` has a record of its own.
  std::function<Built(std::span<const PackedMap> before, std::span<const PackedMap> maps, const Options&)>
      build = {};
  std::function<std::vector<Violation>(const Input&)> validate = {};

  bool has(Entry e) const;
};

class MicromapSubject final : public Subject {
 public:
  MicromapSubject(std::string name, std::string about, Functions functions, std::string fingerprint = {})
      : Subject("micromap", std::move(name), std::move(about)),
        functions(std::move(functions)),
        fingerprint_(std::move(fingerprint)) {}
  /// Maps have no points between theirs.
  bool exact() const override { return true; }
  std::string fingerprint() const override { return fingerprint_; }

  const Functions functions;

 private:
  std::string fingerprint_;
};
using MicromapSubjectPtr = std::shared_ptr<const MicromapSubject>;

/// micromap-spec, micromap, and three lossy codecs: lossy-stable, lossy-conservative, lossy-merge.
const std::vector<MicromapSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
MicromapSubjectPtr built_in(const std::string& name);

}  // namespace mmverify::proofs::micromap
