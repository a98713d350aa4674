// The arguments of an entry point, by the names that the rows of subjects/dock/entry_points.hpp use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "subjects/dock/entry_points.hpp"

namespace mmverify::dock {

struct Arguments {
  std::uint32_t level, format;
  const std::uint8_t* blob;  ///< the map, the code or the case
  std::size_t blob_bytes;
  std::array<const std::byte*, most_arrays> arrays;  ///< `count` numbers each
  std::size_t count;
  std::byte* out;
  std::size_t room;  ///< bytes of the answer to a blob; for an encoder, the most that it may write

  const float* floats(std::size_t k) const { return reinterpret_cast<const float*>(arrays[k]); }
  const double* doubles(std::size_t k) const { return reinterpret_cast<const double*>(arrays[k]); }
  const std::uint32_t* words(std::size_t k) const {
    return reinterpret_cast<const std::uint32_t*>(arrays[k]);
  }
  /// The two formats of two_formats().
  std::uint32_t first() const { return format % formats_side; }
  std::uint32_t second() const { return format / formats_side; }
  float* weights() const { return reinterpret_cast<float*>(out); }
  std::uint32_t* numbers() const { return reinterpret_cast<std::uint32_t*>(out); }
  std::uint8_t* bytes() const { return reinterpret_cast<std::uint8_t*>(out); }
};

/// The case at the start of a blob; the rest of the blob is its texels.
template <class Case>
class CaseOf {
 public:
  explicit CaseOf(const Arguments& a) {
    std::memcpy(&what_, a.blob, sizeof what_);
    what_.texels = a.blob + sizeof what_;
  }
  operator const Case*() const { return &what_; }

 private:
  Case what_;
};

/// The case at the start of a blob; the rest of the blob is its hits.
class HitsOf {
 public:
  explicit HitsOf(const Arguments& a) {
    std::memcpy(&what_, a.blob, sizeof what_);
    // A copy, since hits in the blob may not be aligned.
    std::memcpy(hits_.data(), a.blob + sizeof what_, a.blob_bytes - sizeof what_);
    what_.hits = hits_.data();
  }
  operator const mmverify_blend_case_t*() const { return &what_; }

 private:
  static constexpr std::size_t most = 16;
  mmverify_blend_case_t what_;
  std::array<mmverify_hit_t, most> hits_;
};

/// The case at the start of a blob; its triangles and then their maps are the rest of the blob.
class TrianglesOf {
 public:
  explicit TrianglesOf(const Arguments& a) {
    std::memcpy(&what_, a.blob, sizeof what_);
    // A copy, since triangles in the blob may not be aligned.
    triangles_.resize(what_.count);
    const std::size_t bytes = triangles_.size() * sizeof(mmverify_array_triangle_t);
    if (bytes != 0) std::memcpy(triangles_.data(), a.blob + sizeof what_, bytes);
    what_.triangles = triangles_.data();
    what_.maps = a.blob + sizeof what_ + bytes;
  }
  operator const mmverify_array_case_t*() const { return &what_; }

 private:
  mmverify_array_case_t what_;
  std::vector<mmverify_array_triangle_t> triangles_;
};

}  // namespace mmverify::dock
