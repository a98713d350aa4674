// impl/index/index.hpp against the exact specification, over raw bits.
//
// Input: records of 9 bytes, little-endian: the bits of u, the bits of v, a level (its low 5 bits; 17 and
// above stand for 16, as in impl).  Bytes after the last whole record are ignored.  Each record is judged
// alone, scalar against specification; then all together go through the span functions at an odd length,
// spans against scalar.
//
// Covers: impl/index/index.* impl/index/*-inl.hpp
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fuzz/exact_float.hpp"
#include "impl/index/index.hpp"
#include "spec/index/index.hpp"

namespace {

namespace fast = mmverify::impl::index;
namespace spec = mmverify::spec;
using namespace mmverify::fuzz;

struct Record {
  float u, v;
  std::uint32_t level;
};

std::uint32_t word_at(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

std::vector<Record> records_of(const std::uint8_t* data, std::size_t size) {
  std::vector<Record> records;
  for (; size >= 9; data += 9, size -= 9)
    records.push_back(
        {std::bit_cast<float>(word_at(data)), std::bit_cast<float>(word_at(data + 4)), data[8] & 31u});
  return records;
}

[[noreturn]] void mismatch(const char* what, const Record& r, std::uint32_t expected, std::uint32_t got) {
  std::fprintf(stderr, "index_differential: %s at u=%a (0x%08x) v=%a (0x%08x) level %u: expected %u got %u\n",
               what, static_cast<double>(r.u), std::bit_cast<std::uint32_t>(r.u), static_cast<double>(r.v),
               std::bit_cast<std::uint32_t>(r.v), r.level, expected, got);
  std::abort();
}

void require_equal(const char* what, const Record& r, std::uint32_t expected, std::uint32_t got) {
  if (got != expected) mismatch(what, r, expected, got);
}

template <class A, class B>
void require_same_corners(const char* what, const Record& r, const A& expected, const B& got) {
  for (std::size_t c = 0; c < 3; ++c) {
    require_equal(what, r, expected[c].i, got[c].i);
    require_equal(what, r, expected[c].j, got[c].j);
  }
}

// The finite number with the same answer: NaN counts as 0, and an infinity is clamped like any number beyond
// [0,1].
float finite_twin(float x) {
  if (std::isnan(x)) return 0;
  return std::isinf(x) ? std::copysign(2.0f, x) : x;
}

struct Expected {
  std::uint32_t curve, rows;
};

// reference() clamps by itself; w_minor() is a statement about the triangle and gets the clamped point.
template <spec::Number Q>
Expected specified(const spec::Point<Q>& p, const spec::Point<Q>& clamped, spec::Level n) {
  return {spec::index::reference(p, n), spec::index::w_minor(clamped, n)};
}

Expected specified(float u, float v, spec::Level n) {
  const auto clamp = [](float x) { return x > 0 ? (x < 1 ? x : 1.0f) : 0.0f; };
  const float cu = clamp(u), cv = clamp(v);
  if (fits_fixed128(u) && fits_fixed128(v))
    return specified<spec::Fixed128>({exact_fixed128(u), exact_fixed128(v)},
                                     {exact_fixed128(cu), exact_fixed128(cv)}, n);
  return specified<spec::Rational>({exact_rational(u), exact_rational(v)},
                                   {exact_rational(cu), exact_rational(cv)}, n);
}

// The bits of u and v also serve as an index, so that every index can occur.
std::uint32_t any_index(const Record& r) {
  return std::bit_cast<std::uint32_t>(r.u) ^ std::bit_cast<std::uint32_t>(r.v) << 7;
}

void check_one(const Record& r) {
  const spec::Level n = r.level < fast::max_level ? r.level : fast::max_level;
  const std::uint64_t count = std::uint64_t{1} << (2 * n);
  const Expected expected = specified(finite_twin(r.u), finite_twin(r.v), n);
  const std::uint32_t curve = fast::from_barycentrics(r.u, r.v, r.level),
                      rows = fast::w_minor(r.u, r.v, r.level);
  require_equal("from_barycentrics", r, expected.curve, curve);
  require_equal("w_minor", r, expected.rows, rows);
  require_equal("from_barycentrics in range", r, 1, curve < count);
  require_equal("w_minor in range", r, 1, rows < count);

  const std::uint32_t any = any_index(r);
  const auto low = static_cast<std::uint32_t>(count - 1);
  for (const std::uint32_t index : {curve, any})
    require_same_corners("corners", r, spec::index::corners(index & low, n), fast::corners(index, r.level));
  for (const std::uint32_t index : {rows, any})
    require_same_corners("w_minor_corners", r, spec::index::w_minor_corners(index),
                         fast::w_minor_corners(index));
}

void check_batch(std::vector<Record> records) {
  if (records.size() % 2 == 0) records.push_back(records.front());
  const std::size_t count = records.size();
  const std::uint32_t level = records.front().level;

  // Vectors of the exact size: the sanitizer sees any step over their ends.
  std::vector<float> u(count), v(count);
  std::vector<std::uint32_t> index(count), curve(count), rows(count);
  for (std::size_t k = 0; k < count; ++k) {
    u[k] = records[k].u;
    v[k] = records[k].v;
    index[k] = any_index(records[k]);
  }
  std::array<std::vector<std::uint32_t>, 6> x, y;
  for (auto* columns : {&x, &y})
    for (auto& column : *columns) column.resize(count);
  fast::from_barycentrics(u, v, level, curve);
  fast::w_minor(u, v, level, rows);
  fast::corners(index, level, {x[0], x[1], x[2], x[3], x[4], x[5]});
  fast::w_minor_corners(index, {y[0], y[1], y[2], y[3], y[4], y[5]});

  const auto corners_at = [](const auto& c, std::size_t k) {
    return fast::Corners{fast::Vertex{c[0][k], c[1][k]}, fast::Vertex{c[2][k], c[3][k]},
                         fast::Vertex{c[4][k], c[5][k]}};
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Record r{u[k], v[k], level};
    require_equal("batched from_barycentrics", r, fast::from_barycentrics(r.u, r.v, level), curve[k]);
    require_equal("batched w_minor", r, fast::w_minor(r.u, r.v, level), rows[k]);
    require_same_corners("batched corners", r, fast::corners(index[k], level), corners_at(x, k));
    require_same_corners("batched w_minor_corners", r, fast::w_minor_corners(index[k]), corners_at(y, k));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<Record> records = records_of(data, size);
  if (records.empty()) return 0;
  for (const Record& r : records) check_one(r);
  check_batch(records);
  return 0;
}
