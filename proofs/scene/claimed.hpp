// The micro-triangles of a level that a claim is about, in order, so that one can be drawn by its number.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "proofs/engine/result.hpp"
#include "proofs/scene/claim.hpp"

namespace mmverify::proofs::scene {

/// A micro-triangle of a planned triangle.
struct MicroTriangle {
  std::size_t triangle;
  std::uint32_t index;
};

class Claimed {
 public:
  /// Domain: maps that outlive this object.
  Claimed(const Claim& claim, const mmverify::scene::Baked& baked, Level n);

  std::uint64_t size() const { return before_.back(); }
  /// Micro-triangle number k: triangle by triangle, by index.  From any thread.
  /// Domain: k < size().  Cost: a search among triangles and blocks, and a walk through a block; the blocks of a map
  /// are counted at its first call.
  MicroTriangle at(std::uint64_t k) const;

 private:
  static constexpr std::uint32_t block = 256;  ///< micro-triangles
  struct Blocks {
    std::once_flag counted;
    std::vector<std::uint32_t> before;  ///< by block, and all of them last
  };
  const std::vector<std::uint32_t>& blocks_of(std::size_t position) const;

  const Claim claim_;
  const mmverify::scene::Baked& baked_;
  std::vector<std::size_t> triangles_;    ///< with such micro-triangles
  std::vector<std::uint64_t> before_{0};  ///< their micro-triangles in those before, and all of them last
  std::unique_ptr<Blocks[]> blocks_;
};

}  // namespace mmverify::proofs::scene
