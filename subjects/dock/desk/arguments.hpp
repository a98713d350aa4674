// The arguments of an entry point, by the names that the rows of subjects/dock/entry_points.hpp use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

#include "subjects/dock/desk/manner.hpp"
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
  Manner manner = Manner::plain;
  /// Memory for the case's struct and what it points to besides the blob, aligned, of room_for_case() bytes;
  /// null: the call has its own.
  std::byte* case_room = nullptr;

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

/// A value in the case's room if the call has one, else here.
template <class T>
class InCaseRoom {
 public:
  /// Domain: `at` bytes of the room are taken.
  InCaseRoom(const Arguments& a, std::size_t at)
      : value_(a.case_room != nullptr ? new (a.case_room + at) T : &own_) {}
  T* operator->() const { return value_; }
  T* get() const { return value_; }

 private:
  T own_;
  T* value_;
};

/// Bytes of a case's room: the blob holds the struct and whatever is copied besides; a copy of hits has room
/// for more than the blob's.
constexpr std::size_t case_alignment = 16;
constexpr std::size_t room_for_case(std::size_t blob_bytes) { return blob_bytes + 512; }
template <class Case>
constexpr std::size_t behind_case = (sizeof(Case) + case_alignment - 1) / case_alignment* case_alignment;

/// The case at the start of a blob; the rest of the blob is its texels.
template <class Case>
class CaseOf {
 public:
  explicit CaseOf(const Arguments& a) : what_(a, 0) {
    std::memcpy(what_.get(), a.blob, sizeof(Case));
    what_->texels = a.blob + sizeof(Case);
  }
  operator const Case*() const { return what_.get(); }

 private:
  InCaseRoom<Case> what_;
};

/// The case at the start of a blob; the rest of the blob is its hits.
class HitsOf {
 public:
  explicit HitsOf(const Arguments& a) : what_(a, 0), hits_(a, behind_case<mmverify_blend_case_t>) {
    std::memcpy(what_.get(), a.blob, sizeof(mmverify_blend_case_t));
    // A copy, since hits in the blob may not be aligned.
    std::memcpy(hits_.get(), a.blob + sizeof(mmverify_blend_case_t),
                a.blob_bytes - sizeof(mmverify_blend_case_t));
    what_->hits = hits_->data();
  }
  operator const mmverify_blend_case_t*() const { return what_.get(); }

 private:
  static constexpr std::size_t most = 16;
  InCaseRoom<mmverify_blend_case_t> what_;
  InCaseRoom<std::array<mmverify_hit_t, most>> hits_;
};

/// The case at the start of a blob; its triangles and then their maps are the rest of the blob.
class TrianglesOf {
 public:
  explicit TrianglesOf(const Arguments& a) : what_(a, 0) {
    std::memcpy(what_.get(), a.blob, sizeof(mmverify_array_case_t));
    // A copy, since triangles in the blob may not be aligned.
    const std::size_t bytes = what_->count * sizeof(mmverify_array_triangle_t);
    void* triangles = nullptr;
    if (a.case_room != nullptr) {
      triangles = a.case_room + behind_case<mmverify_array_case_t>;
    } else {
      triangles_.resize(what_->count);
      triangles = triangles_.data();
    }
    if (bytes != 0) std::memcpy(triangles, a.blob + sizeof(mmverify_array_case_t), bytes);
    what_->triangles = static_cast<const mmverify_array_triangle_t*>(triangles);
    what_->maps = a.blob + sizeof(mmverify_array_case_t) + bytes;
  }
  operator const mmverify_array_case_t*() const { return what_.get(); }

 private:
  InCaseRoom<mmverify_array_case_t> what_;
  std::vector<mmverify_array_triangle_t> triangles_;
};

/// The case at the start of a blob, and its surface; then come the indices, the coordinates, the levels, if the case has
/// some, and the texels.
class MeshOf {
 public:
  explicit MeshOf(const Arguments& a) : what_(a, 0), surface_(a, behind_case<mmverify_mesh_case_t>) {
    std::memcpy(what_.get(), a.blob, sizeof(mmverify_mesh_case_t));
    std::memcpy(surface_.get(), a.blob + sizeof(mmverify_mesh_case_t), sizeof(mmverify_bake_case_t));
    const std::uint8_t* const numbers = a.blob + sizeof(mmverify_mesh_case_t) + sizeof(mmverify_bake_case_t);
    // The asking process has no address here: any pointer but null means that there are levels.
    const bool has_levels = what_->levels != nullptr;
    const std::size_t indices = std::size_t{3} * what_->triangles, uvs = std::size_t{2} * what_->vertices,
                      count = indices + uvs + (has_levels ? what_->triangles : 0);
    // A copy, since numbers in the blob may not be aligned.
    std::byte* copy = nullptr;
    if (a.case_room != nullptr) {
      copy = a.case_room + behind_case<mmverify_mesh_case_t> + behind_case<mmverify_bake_case_t>;
    } else {
      numbers_.resize(count);
      copy = reinterpret_cast<std::byte*>(numbers_.data());
    }
    std::memcpy(copy, numbers, count * sizeof(std::uint32_t));
    what_->indices = reinterpret_cast<const std::uint32_t*>(copy);
    what_->uvs = reinterpret_cast<const float*>(copy + indices * sizeof(std::uint32_t));
    if (has_levels) what_->levels = what_->indices + indices + uvs;
    surface_->texels = numbers + count * sizeof(std::uint32_t);
    what_->surface = surface_.get();
  }
  operator const mmverify_mesh_case_t*() const { return what_.get(); }

 private:
  InCaseRoom<mmverify_mesh_case_t> what_;
  InCaseRoom<mmverify_bake_case_t> surface_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace mmverify::dock
