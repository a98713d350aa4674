#include "proofs/index/subject.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

namespace mmverify::proofs::index {
namespace {
[[noreturn]] void absent(const IndexSubject& s, const char* entry) {
  throw std::logic_error(fmt::format("{} has no entry point {}", s.name(), entry));
}
}  // namespace

std::string to_string(Arithmetic a) {
  switch (a) {
    case Arithmetic::exact:
      return "exact";
    case Arithmetic::binary16:
      return "binary16";
    case Arithmetic::binary32:
      return "binary32";
    case Arithmetic::binary64:
      return "binary64";
  }
  return "?";
}

void IndexSubject::index(Level, Batch, std::span<std::uint32_t>) const { absent(*this, "index"); }
void IndexSubject::index(Level, FloatBatch, std::span<std::uint32_t>) const { absent(*this, "index"); }
void IndexSubject::index_rows(Level n, Level grid, std::span<const Row> rows,
                              std::span<std::uint32_t> out) const {
  std::vector<GridPoint> points;
  for (const Row& row : rows) {
    points.resize(row.count);
    for (std::uint64_t t = 0; t < row.count; ++t) points[t] = representative(row, t, grid);
    index(n, {points, true}, out.first(row.count));
    out = out.subspan(row.count);
  }
}
void IndexSubject::index(Level n, DoubleBatch batch, std::span<std::uint32_t> out) const {
  for (std::size_t t = 0; t < out.size(); ++t)
    out[t] = index(n, RationalPoint{rational(batch.u[t]), rational(batch.v[t])});
}
std::uint32_t IndexSubject::index(Level, const RationalPoint&) const { absent(*this, "index"); }
void IndexSubject::corners(Level, std::span<const std::uint32_t>, std::span<Corners>) const {
  absent(*this, "corners");
}
void IndexSubject::row_index(Level, Batch, std::span<std::uint32_t>) const { absent(*this, "row_index"); }
void IndexSubject::row_index(Level, FloatBatch, std::span<std::uint32_t>) const {
  absent(*this, "row_index");
}
std::uint32_t IndexSubject::row_index(Level, const RationalPoint&) const { absent(*this, "row_index"); }
void IndexSubject::row_corners(Level, std::span<const std::uint32_t>, std::span<Corners>) const {
  absent(*this, "row_corners");
}
void IndexSubject::wide_index(Level, const Row&, std::span<std::uint64_t>) const {
  absent(*this, "wide index");
}
std::uint64_t IndexSubject::wide_index(Level, const RationalPoint&) const { absent(*this, "wide index"); }

}  // namespace mmverify::proofs::index
