#include "proofs/index/grid/reference_sweep.hpp"

// The compiler vectorises the plain loops, once for each machine named here; the binary picks a version as it starts.
#ifdef __x86_64__
#define MMVERIFY_FOR_EACH_MACHINE __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define MMVERIFY_FOR_EACH_MACHINE
#endif

namespace mmverify::proofs::index {
namespace {

/// Coordinates of grid points up to level 14, and their products with N: k/2^(g+2) needs 16 fraction bits, and
/// N = 2^14 times 2^16 is below 2^31.
using Fixed32 = spec::Fixed<std::int32_t, 16>;
constexpr Level narrow_levels = 14;

MMVERIFY_FOR_EACH_MACHINE void narrow_row(Level n, Level grid, const Row& row, std::uint32_t* index) {
  const std::int32_t raw = std::int32_t{1} << (Fixed32::fraction_bits - (grid + 2));
  const auto u = static_cast<std::int32_t>(row.ku) * raw, du = static_cast<std::int32_t>(row.stride) * raw;
  const auto v = static_cast<std::int32_t>(row.kv) * raw;
  const auto count = static_cast<std::int32_t>(row.count);
  for (std::int32_t t = 0; t < count; ++t) {
    const auto number = [](std::int32_t r) { return Fixed32::from_raw(r); };
    index[t] = spec::index::reference(spec::Point<Fixed32>{number(u + t * du), number(v)}, n);
  }
}

MMVERIFY_FOR_EACH_MACHINE void wide_row(Level n, Level grid, const Row& row, std::uint32_t* index) {
  const std::uint64_t count = row.count;
  for (std::uint64_t t = 0; t < count; ++t)
    index[t] = spec::index::reference(representative(row, t, grid), n);
}

}  // namespace

MMVERIFY_FOR_EACH_MACHINE void reference_batch(Level n, std::span<const GridPoint> points,
                                               std::span<std::uint32_t> out) {
  const std::size_t count = points.size();
  const GridPoint* p = points.data();
  std::uint32_t* index = out.data();
  for (std::size_t t = 0; t < count; ++t) index[t] = spec::index::reference(p[t], n);
}

void reference_rows(Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out) {
  const bool narrow = n <= narrow_levels && grid <= narrow_levels;
  std::uint32_t* index = out.data();
  for (const Row& row : rows) {
    (narrow ? narrow_row : wide_row)(n, grid, row, index);
    index += row.count;
  }
}

MMVERIFY_FOR_EACH_MACHINE void reference_wide_row(Level n, const Row& row, std::span<std::uint64_t> out) {
  const std::int64_t raw = std::int64_t{1} << (Fixed64::fraction_bits - (n + 2));
  const std::int64_t u = row.ku * raw, du = row.stride * raw, v = row.kv * raw;
  const auto count = static_cast<std::int64_t>(row.count);
  std::uint64_t* index = out.data();
  for (std::int64_t t = 0; t < count; ++t)
    index[t] = spec::index::reference_wide(GridPoint{Fixed64::from_raw(u + t * du), Fixed64::from_raw(v)}, n);
}

}  // namespace mmverify::proofs::index
