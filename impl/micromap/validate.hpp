// The array validator: all violations of the rules of EXT, KHR, DXR and glTF in one linear pass and a sort.
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

/// The limits of a device.  Source: VkPhysicalDeviceOpacityMicromapPropertiesKHR.
struct Limits {
  std::uint32_t two_state_level = 12, four_state_level = 12, lossy_four_state_level = 12;
  std::uint64_t triangles = std::numeric_limits<std::uint64_t>::max();  ///< maxMicromapTriangles
};

/// An untrusted array, and a geometry that refers to it.
struct Input {
  Sets sets = all_sets;  ///< specifications whose rules apply
  Limits limits = {};
  bool lossy = false;  ///< a lossy build (KHR)

  std::span<const std::uint8_t> records = {};
  std::uint64_t record_count = 0, record_stride = record_bytes, records_address = 0;
  std::span<const std::uint8_t> data = {};
  std::uint64_t data_address = 0;
  std::optional<std::span<const UsageCount>> array_counts = {};

  std::uint64_t triangles = 0;  ///< triangles of the geometry; 0: no geometry
  bool indexed = false;         ///< otherwise triangle t has index t
  std::span<const std::uint8_t> indices = {};
  Encoding encoding = Encoding::u32;
  std::uint64_t index_stride = 4, indices_address = 0;
  std::uint32_t base_triangle = 0;
  std::optional<std::span<const UsageCount>> geometry_counts = {};  ///< EXT only; other sets ignore it
};

/// The meaning of a violation's `where`: a number of records, counts or triangles, or a level and a format.
enum class Place : std::uint8_t { whole, record, array_count, geometry_count, level_and_format, triangle };

/// One violation.  The meaning of found and other depends on the rule; describe() writes it in words.
struct Violation {
  Rule rule;
  Place place;
  std::uint64_t where, found, other;
  friend constexpr auto operator<=>(const Violation&, const Violation&) = default;
};

/// All violations of the rules of the given sets, in the order of Violation; empty for a clean array.
/// A record that overlaps others is listed once, with the one that reaches furthest into it.  Without an index buffer
/// the first triangle out of range stands for those after it; with a stride of 0, triangle 0 stands for all.  If
/// records or indices are missing, or an index names no record, counts that depend on them are not judged.
/// Domain: any input; nothing is read outside the spans, whatever the counts, strides and offsets.  Time: O(n log n) in
/// the given bytes.
/// Law: micromap.validate
std::vector<Violation> validate(const Input& in);

/// A list of violations, some of which are only counted.
struct Violations {
  std::vector<Violation> list = {};         ///< the first of each rule, and all at usage counts, in order
  std::map<Rule, std::uint64_t> more = {};  ///< number of a rule's violations that are not listed; none is 0
};

/// The validator of one array, judged once, and of any number of geometries.
///   validate(in) = array() and geometry(in), in order, if nothing is left out.
/// At most `most` violations of one rule are listed, save at usage counts, whose number the input bounds anyway.
/// Domain: any input, as validate().  The spans of `array` are read by the constructor alone; its counts by geometry()
/// too.
class ArrayValidator {
 public:
  /// Judges the members of the array, not those of a geometry.
  /// Time: O(n log n).  Memory: 16 bytes a record, of which 8 are kept.
  /// Test: impl_micromap_validate_test
  ArrayValidator(const Input& array, std::size_t most);
  ~ArrayValidator();
  ArrayValidator(const ArrayValidator&) = delete;
  ArrayValidator& operator=(const ArrayValidator&) = delete;

  const Violations& array() const;

  /// The violations of a geometry that refers to the array; the array's members of `geometry` are ignored.
  /// Time: O(t + c log c) for t triangles with indices and c usage counts, whatever the number of records.
  /// Test: impl_micromap_validate_test
  Violations geometry(const Input& geometry) const;

 private:
  struct Judged;
  std::unique_ptr<const Judged> judged_;
};

/// The violation in one line: the rule's id and the specifications that have it, the place, the fault:
/// "index.encoding (EXT): indices are u8".
/// Test: impl_micromap_validate_test
std::string describe(const Violation& violation);

}  // namespace mmverify::impl::micromap
