#include "proofs/scene/subject_maps.hpp"

#include <bit>
#include <limits>
#include <variant>

#include "proofs/bake/truth/truth.hpp"
#include "proofs/points/point.hpp"
#include "scene/bake/surface_baker.hpp"

namespace mmverify::proofs::scene {
namespace {

using mmverify::scene::Surface;
using spec::micromap::unknown;

/// Texels that fit beside a case into the memory that is shared with a worker.
constexpr std::uint64_t most_bytes = 15u << 20;

bake::Wrap address_of(mmverify::scene::Wrap wrap) {
  switch (wrap) {
    case mmverify::scene::Wrap::repeat: return bake::Wrap::repeat;
    case mmverify::scene::Wrap::mirrored_repeat: return bake::Wrap::mirrored_repeat;
    case mmverify::scene::Wrap::clamp_to_edge: break;
  }
  return bake::Wrap::clamp_to_edge;
}

/// A binary32 number as a fraction of 32 bits.
std::optional<bake::Cutoff> fraction_of(float cutoff) {
  const spec::Rational exact = points::rational(cutoff);
  const spec::Integer limit = std::numeric_limits<std::uint32_t>::max();
  if (exact.numerator() > limit || exact.denominator() > limit) return std::nullopt;
  return bake::Cutoff{static_cast<std::uint32_t>(exact.numerator()),
                      static_cast<std::uint32_t>(exact.denominator())};
}

bake::State our_state(const mmverify::scene::BakedTriangle& t, std::size_t k) {
  if (t.uniform) return static_cast<bake::State>(*t.uniform);
  const unsigned bits = impl::micromap::bits(t.format);
  return static_cast<bake::State>(t.map[k * bits / 8] >> k * bits % 8 & ((1u << bits) - 1));
}

double ns_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

SubjectMaps::SubjectMaps(const Data& data, bake::BakeSubjectPtr subject)
    : data_(data),
      subject_(std::move(subject)),
      asked_(std::make_unique<TriangleAnswer[]>(data.plan.triangles.size())) {}

std::optional<bake::Case> SubjectMaps::case_without_texels(std::size_t triangle) const {
  const auto& planned = data_.plan.triangles.at(triangle);
  const Surface& surface = data_.plan.surfaces.at(planned.surface);
  const auto& image = data_.scene.images.at(surface.image);
  if (std::uint64_t{image.width} * image.height * static_cast<unsigned>(image.bits() / 8) > most_bytes)
    return std::nullopt;
  const auto cutoff = fraction_of(surface.cutoff);
  if (!cutoff || planned.varies()) return std::nullopt;
  bake::Case one;
  one.width = image.width;
  one.height = image.height;
  one.texel = static_cast<bake::Texel>(image.alpha.index());  // both: bytes, words, floats
  one.filter = filter_of(surface.sampler) == mmverify::scene::Filter::nearest ? bake::Filter::nearest
                                                                              : bake::Filter::bilinear;
  one.wrap_u = address_of(surface.sampler.wrap_u);
  one.wrap_v = address_of(surface.sampler.wrap_v);
  one.factor = surface.base_color_alpha;
  one.vertex_factor = surface.vertex_alpha;
  one.blend = surface.mode == mmverify::scene::AlphaMode::blend;
  if (!one.blend) one.cutoff = *cutoff;
  one.margin = data_.margin;
  one.travel = surface.travel;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 2; ++axis) one.uv[2 * k + axis] = planned.uvs[k][axis];
  return one;
}

bool SubjectMaps::asks(std::size_t triangle) const {
  const bake::Support& support = subject_->functions.support;
  const std::optional<bake::Case> one = case_without_texels(triangle);
  return one && support.four_state && data_.baked.triangles[triangle].level <= support.max_level &&
         covers(support, *one);
}

bake::Case SubjectMaps::case_of(std::size_t triangle) const {
  bake::Case one = case_without_texels(triangle).value();
  const Surface& surface = data_.plan.surfaces[data_.plan.triangles[triangle].surface];
  one.alpha.clear();
  std::visit(
      [&]<class Texel>(const std::vector<Texel>& alpha) {
        for (const Texel texel : alpha)
          if constexpr (std::is_same_v<Texel, float>)
            one.alpha.push_back(std::bit_cast<std::uint32_t>(texel));
          else
            one.alpha.push_back(texel);
      },
      data_.scene.images[surface.image].alpha);
  return one;
}

void SubjectMaps::ask(std::size_t triangle, TriangleAnswer& asked) const {
  const auto& ours = data_.baked.triangles.at(triangle);
  const bake::Case one = case_of(triangle);
  std::optional<bake::Baked> baked;
  asked.ns = ns_of([&] { baked = subject_->functions.bake(one, ours.level, bake::Format::four_state); });
  if (!baked) {
    asked.answer = Answer::declined;
    return;
  }
  const auto& planned = data_.plan.triangles[triangle];
  const auto baker =
      mmverify::scene::surface_baker(data_.scene, data_.plan.surfaces[planned.surface], data_.margin);
  impl::micromap::Bytes map((baked->states.size() + 3) / 4);
  const auto& uv = planned.uvs;
  asked.our_ns = ns_of([&] {
    const auto& travel = data_.plan.surfaces[planned.surface].travel;
    baker.bake_moving(
        {{{{uv[0][0], uv[0][1]}, {uv[1][0], uv[1][1]}, {uv[2][0], uv[2][1]}}}, travel[0], travel[1]},
        ours.level, map);
  });
  for (std::size_t k = 0; k < baked->states.size(); ++k) {
    const bake::State got = baked->states[k], right = our_state(ours, k);
    if (!unknown(got) && got != right) asked.wrong.known.push_back(static_cast<std::uint32_t>(k));
    if (unknown(got) && !unknown(right)) asked.wrong.unknown.push_back(static_cast<std::uint32_t>(k));
  }
  // Ours go by the header's rules: what differs may be right by others.
  const bake::Case ruled = fitted(subject_->functions.support, one, 0);
  if (ruled.rules != bake::Rules{}) {
    const auto left = [&](std::vector<std::uint32_t>& wrong, auto denies) {
      const bake::Truth truth = bake::true_states(ruled, ours.level, wrong);
      std::vector<std::uint32_t> denied;
      for (std::size_t k = 0; k < wrong.size(); ++k)
        if (denies(baked->states[wrong[k]], truth.lower[k], truth.upper[k])) denied.push_back(wrong[k]);
      wrong = std::move(denied);
    };
    left(asked.wrong.known, [](bake::State got, bake::State lower, bake::State upper) {
      return got == bake::State::O ? lower != bake::State::O : upper != bake::State::T;
    });
    left(asked.wrong.unknown, [](bake::State, bake::State lower, bake::State upper) {
      return upper == bake::State::O || lower == bake::State::T;
    });
  }
  asked.answer = Answer::baked;
}

const WrongStates* SubjectMaps::wrong(std::size_t triangle) const {
  TriangleAnswer& asked = asked_[triangle];
  std::call_once(asked.once, [&] { ask(triangle, asked); });
  return asked.answer == Answer::baked ? &asked.wrong : nullptr;
}

SubjectTotals SubjectMaps::totals() const {
  SubjectTotals sum;
  for (std::size_t k = 0; k < data_.plan.triangles.size(); ++k) {
    const TriangleAnswer& asked = asked_[k];
    const Answer answer = asked.answer;
    ++sum.triangles;
    sum.outside += asks(k) ? 0 : 1;
    sum.declined += answer == Answer::declined ? 1 : 0;
    if (answer != Answer::baked) continue;
    sum.micro_triangles += impl::micromap::micro_triangles(data_.baked.triangles[k].level);
    sum.wrong_known += asked.wrong.known.size();
    sum.needless_unknown += asked.wrong.unknown.size();
    sum.ns += asked.ns;
    sum.our_ns += asked.our_ns;
  }
  if (sum.micro_triangles != 0) {
    sum.ns /= static_cast<double>(sum.micro_triangles);
    sum.our_ns /= static_cast<double>(sum.micro_triangles);
  }
  return sum;
}

}  // namespace mmverify::proofs::scene
