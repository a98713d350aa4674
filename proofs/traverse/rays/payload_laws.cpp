// Laws of hits that blend along real rays.  The payload is that of the texture and the specification, in any order in
// which Embree meets the hits.
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/laws.hpp"
#include "proofs/traverse/rays/seen_by.hpp"

namespace mmverify::proofs::traverse {
namespace {

using spec::traverse::Colour;

std::uint64_t payload_cameras(const Run& run) { return run.tier == Tier::fast ? 5 : 250; }

/// The operation of a pixel, one of the three that need no order.
Operation operation_of(const SeenBy& c) { return static_cast<Operation>((c.x + c.y + c.camera) % 3); }

Colour payload_of(Operation o) {
  return o == Operation::min ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 0};
}

/// Hits for a subject, with ranks of t from 1 on as distances.
std::vector<Hit> ranked(const std::vector<impl::traverse::Hit>& hits) {
  std::vector<float> distances;
  for (const auto& h : hits) distances.push_back(h.distance);
  std::sort(distances.begin(), distances.end());
  std::vector<Hit> all;
  for (const auto& h : hits) {
    const auto at = std::lower_bound(distances.begin(), distances.end(), h.distance);
    all.push_back(
        {distance_of(static_cast<float>(at - distances.begin() + 1)), h.accepted, colour_of(h.value)});
  }
  return all;
}

/// The expected payload of a ray that reads the texture: the specification blends the hits before the accepted one,
/// nearest first.
Colour expected_of(Operation o, std::vector<impl::traverse::Hit> hits) {
  std::stable_sort(hits.begin(), hits.end(),
                   [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const auto accepted = std::find_if(hits.begin(), hits.end(), [](const auto& h) { return h.accepted; });
  Colour payload = payload_of(o);
  for (auto h = hits.begin(); h != accepted; ++h)
    if (accepted == hits.end() || h->distance < accepted->distance)
      payload = spec::traverse::blend(o, payload, colour_of(h->value));
  return payload;
}

Finding same_payload(const TraverseSubject& s, const SeenBy& c) {
  const SampleWorld& sample = SampleWorld::get();
  const render::TraceOptions options{.width = picture_width, .height = picture_height};
  const render::Camera camera = c.seen_from();
  const Operation o = operation_of(c);
  render::Blending blending{.operation = static_cast<impl::traverse::Operation>(o),
                            .by = render::BlendedBy::shader,
                            .colours = &sample.colours()};
  const Colour right =
      expected_of(o, sample.tracer().blend_hits(camera, nullptr, blending, options, c.x, c.y).hits);
  const Looked looked(s, c.form);
  std::uint64_t calls = 0;
  for (const render::BlendedBy by : {render::BlendedBy::shader, render::BlendedBy::fixed}) {
    blending.by = by;
    const render::BlendHits met = sample.tracer().blend_hits(camera, &looked, blending, options, c.x, c.y);
    const Colour got = s.functions.gather(o, payload_of(o), ranked(met.hits));
    if (got != right)
      return wrong(fmt::format("{} by {}", text_of_colour(right), name_of(o)),
                   fmt::format("{}, blended by {}", text_of_colour(got),
                               by == render::BlendedBy::shader ? "the any-hit shader" : "fixed functions"));
    calls = 3 * calls + met.asked.shader;
  }
  return Finding{word_of(right) + (calls << 32) + 1};
}

std::function<void(Functions&)> looking(void (*change)(const Looks&, std::optional<State>&)) {
  return spoils(&Functions::look, change);
}

}  // namespace

std::vector<Law> payload_laws() {
  Law law{
      .id = "traverse.same_payload",
      .says =
          "hits along a ray blend to one payload, by max, min and add, whether any-hit shaders blend all of "
          "them or fixed functions those that maps call opaque: that of the texture's hits before the "
          "closest accepted one, nearest first",
      .source = "Color and Attribute Micromaps, 4.3 and figure 6",
      .method = proofs::Method::sample,
      .subjects = {"traverse"},
      .tiers = {.seconds = 1.5},
      .at_once = "levels 0..5",
      .domain = fmt::format(
          "{} x {} pixels of cameras on a random path through a world of our own, each by one of the "
          "three operations, by {} forms of its maps, blended by shaders and by fixed functions",
          picture_width, picture_height, forms().size()),
      .unfit = needing_rays({entry::look, entry::gather}),
      .mutants = {
          mutant("hits are blended as they are met", "traverse",
                 [](Functions& f) { f.gather = spec::traverse::blended_as_met; }),
          mutant("fixed functions blend unknown states", "traverse",
                 looking([](const Looks&, std::optional<State>& a) {
                   if (a && (*a == State::UT || *a == State::UO)) a = State::O;
                 })),
          mutant("opaque states of square maps end no ray and blend nothing", "traverse",
                 looking([](const Looks& asks, std::optional<State>& a) {
                   if (asks.method == render::Method::vq2 && a == State::O) a = State::T;
                 })),
          mutant("the farthest of three hits is lost", "traverse",
                 [](Functions& f) {
                   f.gather = [real = f.gather](Operation o, const Colour& payload,
                                                std::span<const Hit> hits) {
                     std::vector<Hit> kept(hits.begin(), hits.end());
                     if (kept.size() == 3)
                       std::erase_if(
                           kept, [](const Hit& h) { return !h.accepted && h.distance == distance_of(3); });
                     return real(o, payload, kept);
                   };
                 }),
      }};
  return {on_numbered_cases(
      std::move(law),
      {[](Level, const Run& run) { return payload_cameras(run) * pixels_by_forms(); },
       [](const Subject& s, Level, std::uint64_t k, const Run& run) {
         return same_payload(subject_as<TraverseSubject>(s), numbered(k, run));
       },
       [](const Subject&, Level, std::uint64_t k, const Run& run) { return text_of(numbered(k, run)); },
       [](const Subject& s, Level, const std::string& at) {
         return same_payload(subject_as<TraverseSubject>(s), read_seen_by(at));
       },
       picture_width * forms().size(), Kind::interior})};
}

}  // namespace mmverify::proofs::traverse
