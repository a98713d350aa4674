// Memory that a caller has for one call only: afterwards nobody may touch it.
#pragma once

#include <cstddef>
#include <vector>

namespace mmverify::dock {

class Lent {
 public:
  /// The addresses that are tried; if they are taken, the memory lies anywhere.
  enum class Where { anywhere, below_2_gib, below_4_gib };

  /// A piece for each size, in whole pages that it ends with. Throws std::bad_alloc.
  Lent(const std::vector<std::size_t>& sizes, Where where);
  ~Lent();
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

  std::byte* piece(std::size_t k) const { return pieces_[k]; }

  /// Takes the memory back: whoever touches it crashes, and the crash is explained.
  void take_back();

 private:
  std::byte* base_;
  std::size_t bytes_ = 0;
  std::vector<std::byte*> pieces_;
};

}  // namespace mmverify::dock
