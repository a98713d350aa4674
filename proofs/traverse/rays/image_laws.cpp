// Rays through a world, its micromaps asked in every form: what is seen is what the texture alone decides.
#include "impl/index/index.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/laws.hpp"
#include "proofs/traverse/rays/seen_by.hpp"

namespace mmverify::proofs::traverse {
namespace {

using render::Barycentrics;
using render::Method;

std::uint64_t cameras(const Run& run) { return run.tier == Tier::fast ? 10 : 500; }

std::string text_of(const render::Pixel& p) {
  if (!p.primary.hit()) return "nothing";
  return fmt::format("instance {} geometry {} triangle {} t {:a}, {}", p.primary.instance, p.primary.geometry,
                     p.primary.triangle, p.primary.t, p.lit ? "lit" : "in shadow");
}

Finding check(const TraverseSubject& s, const SeenBy& c) {
  const SampleWorld& sample = SampleWorld::get();
  const render::TraceOptions options{.width = picture_width, .height = picture_height};
  const render::Camera camera = c.seen_from();
  const Looked looked(s, c.form);
  const render::Pixel by_texture = sample.tracer().pixel(camera, nullptr, options, c.x, c.y),
                      by_maps = sample.tracer().pixel(camera, &looked, options, c.x, c.y);
  if (by_texture.primary == by_maps.primary && by_texture.lit == by_maps.lit)
    return Finding{std::uint64_t{by_maps.primary.triangle} + 2 * by_maps.by_primary.shader + by_maps.lit};
  return wrong(text_of(by_texture), text_of(by_maps));
}

using Asks = Looks;
using Answer = std::optional<State>;

std::function<void(Functions&)> asking(void (*change)(Asks&)) {
  return [change](Functions& f) {
    f.look = [change, real = f.look](Asks asks) {
      change(asks);
      return real(asks);
    };
  };
}

std::function<void(Functions&)> answering(void (*change)(const Asks&, Answer&)) {
  return spoils(&Functions::look, change);
}

/// The middle of the micro-triangle with this number.
Barycentrics middle_of(std::uint32_t number, unsigned level) {
  const impl::index::Corners corners = impl::index::corners(number, level);
  const float size = 3 * static_cast<float>(std::uint32_t{1} << level);
  return {static_cast<float>(corners[0].i + corners[1].i + corners[2].i) / size,
          static_cast<float>(corners[0].j + corners[1].j + corners[2].j) / size};
}

}  // namespace

std::vector<Law> image_laws() {
  Law law{.id = "traverse.same_image",
          .says =
              "rays that ask micromaps first, and the texture where these do not know, meet the same "
              "triangles at the same t, and the same light, as rays that ask the texture alone: with special "
              "indices only, flat maps, the paper's tree, the ranked tree, VQ2 and VQ4",
          .source = "Succinct Opacity Micromaps, 5.2; Compressed Opacity Maps, figures 1 and 12",
          .method = proofs::Method::sample,
          .subjects = {"traverse"},
          .tiers = {.seconds = 1.5},
          .at_once = "levels 0..5",
          .domain = fmt::format(
              "{} x {} pixels of cameras on a random path through a world of our own, a primary ray "
              "and a shadow ray each, by {} forms of its maps",
              picture_width, picture_height, forms().size()),
          .unfit = needing_rays({entry::look}),
          .mutants = {
              mutant("unknown states are opaque", "traverse", answering([](const Asks&, Answer& a) {
                       if (a && (*a == State::UT || *a == State::UO)) a = State::O;
                     })),
              mutant("special indices lose their sign: -1 is O, -2 is T", "traverse",
                     answering([](const Asks& asks, Answer& a) {
                       if (asks.method == Method::special && a && (*a == State::T || *a == State::O))
                         a = *a == State::T ? State::O : State::T;
                     })),
              mutant("at level 5 the index is that of level 4", "traverse", asking([](Asks& asks) {
                       if (asks.method == Method::ranked && asks.level == 5)
                         asks.at = middle_of(impl::index::from_barycentrics(asks.at.u, asks.at.v, 4), 5);
                     })),
              mutant("barycentrics are rounded to 4 bits", "traverse", asking([](Asks& asks) {
                       const auto rounded = [](float x) {
                         return static_cast<float>(static_cast<int>(x * 16 + 0.5f)) / 16;
                       };
                       asks.at = render::in_triangle(rounded(asks.at.u), rounded(asks.at.v));
                     })),
              mutant("u and v are exchanged", "traverse", asking([](Asks& asks) {
                       if (asks.method == Method::tree) std::swap(asks.at.u, asks.at.v);
                     })),
              mutant("the upper half of a square map is not turned", "traverse", asking([](Asks& asks) {
                       if (asks.method == Method::vq4 && asks.triangle % 2 == 1)
                         asks.at = render::in_triangle(1 - asks.at.u, 1 - asks.at.v);
                     })),
          }};
  return {on_numbered_cases(
      std::move(law),
      {[](Level, const Run& run) { return cameras(run) * pixels_by_forms(); },
       [](const Subject& s, Level, std::uint64_t k, const Run& run) {
         return check(subject_as<TraverseSubject>(s), numbered(k, run));
       },
       [](const Subject&, Level, std::uint64_t k, const Run& run) { return text_of(numbered(k, run)); },
       [](const Subject& s, Level, const std::string& at) {
         return check(subject_as<TraverseSubject>(s), read_seen_by(at));
       },
       picture_width * forms().size(), Kind::interior})};
}

}  // namespace mmverify::proofs::traverse
