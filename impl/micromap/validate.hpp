// The array validator: every violation of the rules of EXT, KHR, DXR and glTF in one linear pass and a sort.
#pragma once

#include <compare>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "impl/micromap/array.hpp"
#include "impl/micromap/rules.hpp"

namespace mmverify::impl::micromap {

/// What a device takes.  Source: VkPhysicalDeviceOpacityMicromapPropertiesKHR.
struct Limits {
  std::uint32_t two_state_level = 12, four_state_level = 12, lossy_four_state_level = 12;
  std::uint64_t triangles = std::numeric_limits<std::uint64_t>::max();  ///< maxMicromapTriangles
};

/// An array, and a geometry that refers to it, as somebody hands them over: nothing of it is believed.
struct Input {
  Sets sets = all_sets;  ///< whose rules
  Limits limits = {};
  bool lossy = false;  ///< a lossy build (KHR)

  std::span<const std::uint8_t> records = {};
  std::uint64_t record_count = 0, record_stride = record_bytes, records_address = 0;
  std::span<const std::uint8_t> data = {};
  std::uint64_t data_address = 0;
  std::optional<std::span<const UsageCount>> array_counts = {};

  std::uint64_t triangles = 0;  ///< of the geometry; 0: no geometry
  bool indexed = false;         ///< otherwise triangle t has index t
  std::span<const std::uint8_t> indices = {};
  Encoding encoding = Encoding::u32;
  std::uint64_t index_stride = 4, indices_address = 0;
  std::uint32_t base_triangle = 0;
  std::optional<std::span<const UsageCount>> geometry_counts = {};  ///< EXT only; other sets ignore it
};

/// What a violation's number counts.
enum class Place : std::uint8_t { whole, record, array_count, geometry_count, level_and_format, triangle };

/// One violation.  What found and other are depends on the rule; describe() says it in words.
struct Violation {
  Rule rule;
  Place place;
  std::uint64_t where, found, other;
  friend constexpr auto operator<=>(const Violation&, const Violation&) = default;
};

/// Every violation of the rules of the given sets, in the order of Violation; empty for a clean array.
/// A record that overlaps others is listed once, with the one that reaches furthest into it.  Without an
/// index buffer the first triangle out of range stands for those after it; with a stride of 0, triangle 0
/// stands for all. Where records or indices are missing, or an index names no record, counts that depend on
/// them are not judged.
/// Domain: everything; nothing is read outside the spans, whatever the counts, strides and offsets say. O(n
/// log n) in the bytes given.
std::vector<Violation> validate(const Input& in);

/// Violations of which some are only counted.
struct Violations {
  std::vector<Violation> list = {};         ///< the first of each rule and all at usage counts, in order
  std::map<Rule, std::uint64_t> more = {};  ///< how many of a rule are not listed; none is 0
};

/// An array that is judged once, for any number of geometries.
///   validate(in) = array() and geometry(in), in order, where nothing is left out.
/// Of one rule at most `most` violations are listed, save at usage counts: those are in memory one by one anyway.
/// Domain: everything, as validate().  The spans of `array` are read by the constructor alone; its counts by
/// geometry() too.
class ArrayValidator {
 public:
  /// Judges the members of the array; those of a geometry are not looked at.
  /// O(n log n) time; 16 bytes a record, of which 8 are kept.
  ArrayValidator(const Input& array, std::size_t most);
  ~ArrayValidator();
  ArrayValidator(const ArrayValidator&) = delete;
  ArrayValidator& operator=(const ArrayValidator&) = delete;

  const Violations& array() const;

  /// The violations of a geometry that refers to the array; the array's members of `geometry` are not looked at.
  /// O(t + c log c) time for t triangles that the indices are there for and c usage counts, whatever the number of
  /// records.
  Violations geometry(const Input& geometry) const;

 private:
  struct Judged;
  std::unique_ptr<const Judged> judged_;
};

/// One line: the rule's id, the place, what was found.
/// It begins with the rule's name and the specifications that have it: "index.encoding (EXT): indices are
/// u8".
std::string describe(const Violation& violation);

}  // namespace mmverify::impl::micromap
