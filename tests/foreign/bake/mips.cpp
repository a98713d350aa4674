// The mips of a case: where each begins, and how large it is.
#include "tests/foreign/bake/mips.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tests/foreign/bake/faults.hpp"
#include "tests/foreign/bake/texels.hpp"
#include "tests/foreign/bake/thresholds.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

Index next_size(Index size, Fault odd_up) {
  return has(odd_up) && size > 1 ? (size + 1) / 2 : std::max<Index>(1, size / 2);
}

std::size_t bytes_of(const mmverify_bake_case_t& c) {
  return c.texel == MMVERIFY_UNORM8 ? 1 : c.texel == MMVERIFY_UNORM16 ? 2 : 4;
}

}  // namespace

std::vector<Mip> mips_of(const mmverify_bake_case_t& c) {
  std::vector<Mip> mips;
  const auto* at = static_cast<const unsigned char*>(c.texels);
  const auto* const begin = at;
  std::size_t all = 0;
  for (unsigned k = 0; k < c.mips; ++k)
    all += static_cast<std::size_t>(std::max(1u, k < 32 ? c.width >> k : 0u)) *
           std::max(1u, k < 32 ? c.height >> k : 0u);
  const auto* const end = begin + all * bytes_of(c);
  Index w = c.width, h = c.height;
  for (unsigned k = 0; k < c.mips; ++k) {
    Mip m;
    m.width = w;
    m.height = h;
    m.count = static_cast<std::size_t>(w * h);
    if (at + m.count * bytes_of(c) > end) at = end - m.count * bytes_of(c);  // only with a fault
    if (at < begin) {
      m.width = m.height = 1;
      m.count = 1;
      at = begin;
    }
    const Stored s = read_texels(c, at, m.count, k > 0);
    const auto thresholds = thresholds_of(c, s.full);
    for (std::size_t t = 0; t < thresholds.size(); ++t)
      m.fields.push_back(field_of(c, s, thresholds[t], t == 2));
    std::size_t step = m.count;
    if (has(mip_offset_by_quarters) && k > 0) step = std::max<std::size_t>(1, mips.back().count / 4);
    at += step * bytes_of(c);
    mips.push_back(std::move(m));
    w = next_size(w, mip_rounded_up);
    h = next_size(h, mip_rounded_up);
    if (has(mip_halved_twice) && k == 1) {
      w = (mips.back().width + 1) / 2;
      h = (mips.back().height + 1) / 2;
    }
  }
  return mips;
}

}  // namespace mmverify::tests::foreign::bake
