#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {
namespace {

/// With what stands in for empty functions.
Functions completed(Functions f) {
  if (!f.receive) f.receive = [](std::span<GridPoint>) {};
  if (!f.receive_floats) f.receive_floats = [](std::span<float>, std::span<float>) {};
  if (!f.receive_at) f.receive_at = [](const RationalPoint& p) { return p; };
  if (!f.index && f.index_at)
    f.index = [at = f.index_at](Level n, Batch batch, std::span<std::uint32_t> out) {
      for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(n, rational(batch.points[t]));
    };
  if (!f.index_on_boost) f.index_on_boost = f.index_at;
  if (!f.index_doubles && f.index_at)
    f.index_doubles = [at = f.index_at](Level n, DoubleBatch batch, std::span<std::uint32_t> out) {
      for (std::size_t t = 0; t < out.size(); ++t)
        out[t] = at(n, {rational(batch.u[t]), rational(batch.v[t])});
    };
  if (!f.index_rows && f.index)
    f.index_rows = [index = f.index](Level n, Level grid, std::span<const Row> rows,
                                     std::span<std::uint32_t> out) {
      std::vector<GridPoint> points;
      for (const Row& row : rows) {
        points.resize(row.count);
        for (std::uint64_t t = 0; t < row.count; ++t) points[t] = representative(row, t, grid);
        index(n, {points, true}, out.first(row.count));
        out = out.subspan(row.count);
      }
    };
  return f;
}

}  // namespace

std::string to_string(Arithmetic a) {
  switch (a) {
    case Arithmetic::exact: return "exact";
    case Arithmetic::binary16: return "binary16";
    case Arithmetic::binary32: return "binary32";
    case Arithmetic::binary64: return "binary64";
  }
  return "?";
}

IndexSubject::IndexSubject(std::string name, std::string about, Functions functions, std::string fingerprint)
    : SubjectOf(std::move(name), std::move(about), completed(std::move(functions)), std::move(fingerprint)) {}

}  // namespace mmverify::proofs::index
