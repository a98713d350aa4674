#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/judges/on_cells.hpp"

namespace mmverify::proofs::index {

Tally plain_sweep(Level n, const Run& run) {
  constexpr std::uint64_t cells_per_chunk = 1 << 16;
  const Cells cells(n);
  return sweep(run, cells.size(), cells_per_chunk, [&](Chunk chunk, Tally& tally) {
    cells.rows(chunk.begin, chunk.end, [&](const Row& row) {
      for (std::uint64_t t = 0; t < row.count; ++t) {
        const GridPoint p = representative(row, t, n);
        const std::uint32_t got = spec::index::step<spec::index::Reading::printed>(p, n),
                            want = spec::index::reference(p, n);
        tally.count(row.kind(t), 1);
        tally.digest(row.first + t, got);
        if (got != want)
          tally.mismatch(row.kind(t), simplicity(p),
                         [&] { return at_point(p, n, say_number(want), say_number(got)); });
      }
    });
  });
}

}  // namespace mmverify::proofs::index
