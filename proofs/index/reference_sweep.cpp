#include "proofs/index/reference_sweep.hpp"

namespace mmverify::proofs::index {

// The compiler vectorises the plain loop; the clones let one binary use what the machine has.
__attribute__((target_clones("arch=x86-64-v4", "avx2", "default"))) void reference_batch(
    Level n, std::span<const GridPoint> points, std::span<std::uint32_t> out) {
  const std::size_t count = points.size();
  const GridPoint* p = points.data();
  std::uint32_t* index = out.data();
  for (std::size_t t = 0; t < count; ++t) index[t] = spec::index::reference(p[t], n);
}

}  // namespace mmverify::proofs::index
