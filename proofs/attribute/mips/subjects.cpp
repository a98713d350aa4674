// Mip chains and levels of detail of the built-in subjects.
#include <cmath>

#include "impl/attribute/mip.hpp"
#include "proofs/attribute/subject_parts.hpp"
#include "proofs/points/point.hpp"

namespace mmverify::proofs::attribute {

namespace slow = mmverify::spec::attribute;
namespace fast = mmverify::impl::attribute;

namespace {

std::uint8_t code(std::uint32_t word, unsigned which) { return static_cast<std::uint8_t>(word >> 8 * which); }

/// f of each of the four codes.
template <class F>
std::uint32_t each_code(F f) {
  std::uint32_t word = 0;
  for (unsigned which = 0; which < 4; ++which) word |= static_cast<std::uint32_t>(f(which)) << 8 * which;
  return word;
}

void specified_mip(Rounding rounding, std::span<const std::uint32_t> children,
                   std::span<std::uint32_t> parents) {
  for (std::size_t k = 0; k < parents.size(); ++k)
    parents[k] = each_code([&](unsigned which) {
      return slow::mean_code({code(children[4 * k], which), code(children[4 * k + 1], which),
                              code(children[4 * k + 2], which), code(children[4 * k + 3], which)},
                             rounding);
    });
}

void specified_chain(Level n, Rounding rounding, ChainOf of, std::span<const std::uint32_t> base,
                     std::span<std::uint32_t> chain) {
  const auto level = [&](Level m) {
    return chain.subspan(slow::face_chain(m), static_cast<std::size_t>(slow::face_count(m)));
  };
  std::span<const std::uint32_t> above = base;
  for (Level m = n; m-- > 0; above = level(m)) {
    if (of == ChainOf::level_above) {
      specified_mip(rounding, above, level(m));
      continue;
    }
    const std::uint64_t under = slow::face_count(n - m);
    for (std::size_t k = 0; k < level(m).size(); ++k)
      level(m)[k] = each_code([&](unsigned which) {
        std::uint64_t sum = 0;
        for (std::uint64_t x = k * under; x < (k + 1) * under; ++x) sum += code(base[x], which);
        return slow::rounded(sum, under, rounding);
      });
  }
}

LevelOfDetail specified_lod(Level n, float cone, float triangle) {
  const spec::Rational c = points::rational(cone), t = points::rational(triangle);
  const Level m = slow::lod_level(c, t, n);
  if (m == n || !(c < t)) return {m, 0};
  constexpr unsigned bits = 52;
  return {m, std::ldexp(slow::lod_blend(c, t, m, bits).low.convert_to<double>(), -int{bits})};
}

}  // namespace

Mips specified_mips() {
  Mips f;
  f.face_mip = specified_mip;
  f.face_chain = specified_chain;
  f.face_chain_size = slow::face_chain;
  f.vertex_chain_size = slow::vertex_chain;
  f.vertex_mip_source = [](VertexOrder order, std::uint32_t k, Level m, Level n) {
    return static_cast<std::uint32_t>(slow::vertex_mip_source(order, k, m, n));
  };
  f.lod_level = [](Level n, std::span<const float> cone, std::span<const float> triangle,
                   std::span<Level> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = slow::lod_level(points::rational(cone[k]), points::rational(triangle[k]), n);
  };
  f.lod = specified_lod;
  return f;
}

Mips library_mips() {
  Mips f;
  f.face_mip = [](Rounding rounding, std::span<const std::uint32_t> children,
                  std::span<std::uint32_t> parents) {
    fast::face_mip(children, static_cast<fast::Rounding>(rounding), parents);
  };
  f.face_chain = [](Level n, Rounding rounding, ChainOf of, std::span<const std::uint32_t> base,
                    std::span<std::uint32_t> chain) {
    fast::face_chain(n, base, static_cast<fast::Rounding>(rounding), static_cast<fast::ChainOf>(of), chain);
  };
  f.face_chain_size = fast::face_chain_size;
  f.vertex_chain_size = fast::vertex_chain_size;
  f.vertex_mip_source = [](VertexOrder order, std::uint32_t k, Level m, Level n) {
    return fast::vertex_mip_source(static_cast<fast::VertexOrder>(order), k, m, n);
  };
  f.lod_level = [](Level n, std::span<const float> cone, std::span<const float> triangle,
                   std::span<Level> out) { fast::lod_level(cone, triangle, n, out); };
  f.lod = [](Level n, float cone, float triangle) -> LevelOfDetail {
    const fast::Lod found = fast::lod(cone, triangle, n);
    return {found.level, static_cast<double>(found.blend)};
  };
  return f;
}

}  // namespace mmverify::proofs::attribute
