// A list of violations, written by the parts of the validator.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "impl/micromap/validate.hpp"
#include "scene/read/buffers.hpp"
#include "scene/validate/draft.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/validate/target.hpp"

namespace mmverify::scene {

inline constexpr const char* micromap_extension = text(newest_draft).extension;

class Report {
 public:
  explicit Report(Draft draft = newest_draft, const Target& target = {}) : draft_(draft), target_(target) {}

  /// The draft whose rules are checked.
  Draft draft() const { return draft_; }
  bool newest() const { return draft_ == newest_draft; }
  const char* extension() const { return text(draft_).extension; }

  const Target& target() const { return target_; }

  /// The number of violations of one rule at one place that are listed; the others are only counted.
  static constexpr std::size_t most = 8;
  void add(std::string_view rule, const std::string& pointer, const std::string& found,
           std::vector<std::string_view> vuids = {});

  /// Adds `more` to the count of a rule of which `most` were added at this place.
  void count(std::string_view rule, const std::string& pointer, std::uint64_t more);

  /// Adds a violation of the array's rules by `in`, at the pointer of its place.  The words are describe()'s; the first
  /// that tells of maps' bytes names the suspect_record(), too.
  void add(const impl::micromap::Violation& violation, const impl::micromap::Input& in,
           const std::string& pointer);

  std::vector<FileViolation> taken();

 private:
  Draft draft_;
  Target target_;
  std::vector<FileViolation> list_;
  std::map<std::pair<std::string_view, std::string>, std::uint64_t> counts_;
  std::set<const void*> suspected_;  ///< buffers of records
};

/// The value as a message may show it.
std::string found(const nlohmann::json& value);

/// A whole number from 0, below `end`; none for every other value.
std::optional<std::uint64_t> whole(const nlohmann::json& value, std::uint64_t end = std::uint64_t{1} << 32);

/// The bytes of a view that the extension names.  None, and a finding, if the view lies outside its buffer.
/// A byteStride is a finding, too, in the newest draft.
std::optional<std::span<const unsigned char>> plain_view(const Document& document, const Buffers& buffers,
                                                         std::size_t view, const std::string& pointer,
                                                         Report& report);

/// The number of records of a micromap; none if it could not be read.
using RecordCount = std::optional<std::uint64_t>;

/// Validates the root: one entry for each element of micromaps.
std::vector<RecordCount> validate_root(const Document& document, const Buffers& buffers, Report& report);

/// Validates the primitives.
void validate_primitives(const Document& document, const Buffers& buffers,
                         const std::vector<RecordCount>& micromaps, Report& report);

}  // namespace mmverify::scene
