// The list of violations as the parts of the validator write it.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "impl/micromap/validate.hpp"
#include "scene/read/buffers.hpp"
#include "scene/validate/draft.hpp"
#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

inline constexpr const char* micromap_extension = text(newest_draft).extension;

class Report {
 public:
  explicit Report(Draft draft = newest_draft) : draft_(draft) {}

  /// Whose rules are asked.
  Draft draft() const { return draft_; }
  bool newest() const { return draft_ == newest_draft; }
  const char* extension() const { return text(draft_).extension; }

  /// So many of one rule at one place are kept, and the rest counted: more says nothing new.
  static constexpr std::size_t most = 8;
  void add(std::string_view rule, const std::string& pointer, const std::string& found);

  /// Counts some more of a rule of which `most` were added at this place.
  void count(std::string_view rule, const std::string& pointer, std::uint64_t more);

  /// A violation of the array's rules, by its number's pointer.  Its words are describe()'s.
  void add(const impl::micromap::Violation& violation, const std::string& pointer);

  std::vector<FileViolation> taken();

 private:
  Draft draft_;
  std::vector<FileViolation> list_;
  std::map<std::pair<std::string_view, std::string>, std::uint64_t> counts_;
};

/// The value as a message may show it.
std::string found(const nlohmann::json& value);

/// A whole number from 0, below `end`; none for all else.
std::optional<std::uint64_t> whole(const nlohmann::json& value, std::uint64_t end = std::uint64_t{1} << 32);

/// The bytes of a view that the extension names.  None, and a line, where it lies outside its buffer.  A line alone
/// where it has a byteStride, in the newest draft.
std::optional<std::span<const unsigned char>> plain_view(const Document& document, const Buffers& buffers,
                                                         std::size_t view, const std::string& pointer,
                                                         Report& report);

/// What is known of one micromap; none where it could not be read.
using RecordCount = std::optional<std::uint64_t>;

/// The root's part: one entry for each element of micromaps.
std::vector<RecordCount> validate_root(const Document& document, const Buffers& buffers, Report& report);

/// The primitives' part.
void validate_primitives(const Document& document, const Buffers& buffers,
                         const std::vector<RecordCount>& micromaps, Report& report);

}  // namespace mmverify::scene
