#include "tests/impl/bake_jobs.hpp"

#include <sstream>
#include <stdexcept>

#include "spec/bake/state.hpp"

namespace mmverify::tests {
namespace {

namespace spec = mmverify::spec::bake;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;

spec::Binary32 bits(float x) { return {std::bit_cast<std::uint32_t>(x)}; }

template <class Texel>
auto specified(Texel r) {
  if constexpr (std::is_same_v<Texel, float>)
    return bits(r);
  else
    return r;
}

template <class Texel>
struct Expected {
  using Stored = decltype(specified(Texel{}));
  const Job<Texel>& job;
  std::vector<spec::TextureOf<Stored>> mips;

  explicit Expected(const Job<Texel>& j) : job(j) {
    const Sampling& s = job.sampling;
    for (const Image<Texel>& image : job.mips) {
      spec::TextureOf<Stored> t{image.width, image.height};
      for (const Texel r : image.texels) t.alpha.push_back(specified(r));
      t.wrap_x = static_cast<spec::Wrap>(s.u);
      t.wrap_y = static_cast<spec::Wrap>(s.v);
      t.border = specified(static_cast<Texel>(s.border));
      t.factor = bits(s.factors[0]);
      t.vertex_factor = bits(s.factors[1]);
      t.filter = s.filter == Filter::nearest ? spec::Filter::nearest : spec::Filter::bilinear;
      mips.push_back(t);
    }
  }

  template <class Q>
  int in(std::uint32_t index) const {
    const auto vertex = [&](std::size_t k) { return spec::place<Q>(bits(job.uv[k].u), bits(job.uv[k].v)); };
    const spec::BaseTriangle<Q> base{vertex(0), vertex(1), vertex(2)};
    const auto state = [&](const auto& mode) {
      return static_cast<int>(spec::micro_state(std::span<const spec::TextureOf<Stored>>(mips), base,
                                                job.level, index, mode,
                                                spec::number<Q>(bits(job.sampling.margin))));
    };
    if (const auto* const mask = std::get_if<Mask>(&job.mode))
      return state(spec::Mask<Q>{spec::number<Q>(bits(mask->cutoff))});
    if (const auto* const cutoff = std::get_if<Cutoff>(&job.mode))
      return state(spec::Mask<Q>{spec::fraction<Q>(cutoff->numerator, cutoff->denominator)});
    return state(spec::Blend<Q>{});
  }

  /// In 128 bits where they will do.
  int operator()(std::uint32_t index) const {
    try {
      return in<Rational128>(index);
    } catch (const std::overflow_error&) {
    } catch (const std::range_error&) {
    }
    return in<Rational>(index);
  }
};

template <class Texel>
std::string named(const Job<Texel>& job) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Image<Texel>& image : job.mips) {
    out << image.width << 'x' << image.height << ':';
    for (const Texel r : image.texels) out << ' ' << +r;
    out << "; ";
  }
  const Sampling& s = job.sampling;
  out << "mode " << job.mode.index();
  if (const auto* const mask = std::get_if<Mask>(&job.mode)) out << ' ' << mask->cutoff;
  out << " wrap " << int(s.u) << ' ' << int(s.v) << " filter " << int(s.filter) << " border " << s.border
      << " factors " << s.factors[0] << ' ' << s.factors[1] << " margin " << s.margin << " level "
      << job.level << " uv";
  for (const TexturePoint& p : job.uv) out << " (" << p.u << ", " << p.v << ')';
  return out.str();
}

}  // namespace

template <class Texel>
void expect_specified(const Job<Texel>& job, Seen& seen, std::uint32_t step) {
  const std::uint32_t count = std::uint32_t{1} << (2 * job.level);
  std::vector<std::uint8_t> map((count + 3) / 4, 0xee);
  const BakeCounts counts = baker(job).bake(job.uv, job.level, map);
  ASSERT_EQ(counts.micro_triangles, count);
  seen.leaves += counts.leaves;
  seen.exact += counts.exact;
  const Expected<Texel> expected(job);
  for (std::uint32_t index = 0; index < count; index += step, ++seen.cases) {
    const int code = map[index / 4] >> (2 * (index % 4)) & 3;
    ++seen.states[static_cast<std::size_t>(code)];
    ASSERT_EQ(code, expected(index)) << named(job) << " index " << index;
  }
}

template void expect_specified(const Job<std::uint8_t>&, Seen&, std::uint32_t);
template void expect_specified(const Job<std::uint16_t>&, Seen&, std::uint32_t);
template void expect_specified(const Job<float>&, Seen&, std::uint32_t);

}  // namespace mmverify::tests
