// Rays through a world, its micromaps asked in every form: what is seen is what the texture alone decides.
#include <bit>
#include <charconv>

#include "impl/index/index.hpp"
#include "proofs/spoils.hpp"
#include "proofs/traverse/law_groups.hpp"
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/rays/sample_world.hpp"

namespace mmverify::proofs::traverse {
namespace {

using render::Barycentrics;
using render::Method;

constexpr std::uint32_t picture_width = 32, picture_height = 24;

/// A method's maps at a level; square maps have one.
struct Form {
  Method method = Method::flat;
  unsigned level = 0;
};

const std::vector<Form>& forms() {
  static const std::vector<Form> all = [] {
    std::vector<Form> f;
    for (const Method method : render::methods) {
      if (method == Method::texture) continue;
      for (unsigned level = 0; level <= (render::has_levels(method) ? finest_sample_level : 0); ++level)
        f.push_back({method, level});
    }
    return f;
  }();
  return all;
}

/// A pixel of a camera of a random path, by one form.
struct SeenBy {
  std::uint64_t seed = 1, camera = 1;
  std::uint32_t x = 0, y = 0;
  Form form;
};

std::uint64_t cameras(const Run& run) { return run.tier == Tier::fast ? 10 : 500; }

std::uint64_t case_count(Level, const Run& run) {
  return cameras(run) * picture_width * picture_height * forms().size();
}

SeenBy numbered(std::uint64_t k, const Run& run) {
  SeenBy c;
  c.seed = run.seed;
  c.form = forms()[k % forms().size()];
  k /= forms().size();
  c.x = static_cast<std::uint32_t>(k % picture_width);
  c.y = static_cast<std::uint32_t>(k / picture_width % picture_height);
  c.camera = 1 + k / (picture_width * picture_height);
  return c;
}

std::string text_of(const SeenBy& c) {
  return fmt::format("seed={},camera={},x={},y={},{},level={}", c.seed, c.camera, c.x, c.y,
                     render::name_of(c.form.method), c.form.level);
}

/// The number after `name` at the start of `rest`, which loses it and what ends it.
std::uint64_t number_in(std::string_view& rest, std::string_view name, std::string_view all) {
  const auto bad = [&] {
    return BadCase(fmt::format("'{:.100}': write seed=S,camera=C,x=X,y=Y,METHOD,level=N", all));
  };
  if (!rest.starts_with(name)) throw bad();
  rest.remove_prefix(name.size());
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), n);
  if (error != std::errc()) throw bad();
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (!rest.empty() && rest.front() != ',') throw bad();
  if (!rest.empty()) rest.remove_prefix(1);
  return n;
}

SeenBy read(const std::string& at) {
  std::string_view rest = at;
  SeenBy c;
  c.seed = number_in(rest, "seed=", at);
  c.camera = number_in(rest, "camera=", at);
  const std::uint64_t x = number_in(rest, "x=", at), y = number_in(rest, "y=", at);
  const auto comma = std::min(rest.find(','), rest.size());
  const auto method = render::method_of(rest.substr(0, comma));
  rest.remove_prefix(std::min(comma + 1, rest.size()));
  const std::uint64_t level = number_in(rest, "level=", at);
  if (x >= picture_width || y >= picture_height || !method || *method == Method::texture || !rest.empty() ||
      level > (render::has_levels(*method) ? finest_sample_level : 0))
    throw BadCase(fmt::format("'{:.100}': no such pixel, method or level", at));
  c.x = static_cast<std::uint32_t>(x);
  c.y = static_cast<std::uint32_t>(y);
  c.form = {*method, static_cast<unsigned>(level)};
  return c;
}

/// The subject, asked as a ray tracer asks.
class Looked final : public render::Opacity {
 public:
  Looked(const TraverseSubject& subject, const Form& form) : subject_(subject), form_(form) {}
  std::optional<impl::micromap::State> at(std::uint32_t geometry, std::uint32_t triangle,
                                          const Barycentrics& b) const override {
    const auto state = subject_.functions.look({form_.method, form_.level, geometry, triangle, b});
    return state ? std::optional(static_cast<impl::micromap::State>(*state)) : std::nullopt;
  }
  std::uint64_t bytes() const override { return 0; }

 private:
  const TraverseSubject& subject_;
  const Form form_;
};

std::string text_of(const render::Pixel& p) {
  if (!p.primary.hit()) return "nothing";
  return fmt::format("instance {} geometry {} triangle {} t {:a}, {}", p.primary.instance, p.primary.geometry,
                     p.primary.triangle, p.primary.t, p.lit ? "lit" : "in shadow");
}

Finding check(const TraverseSubject& s, const SeenBy& c) {
  const SampleWorld& sample = SampleWorld::get();
  const render::TraceOptions options{.width = picture_width, .height = picture_height};
  const render::Camera camera = render::on_path(sample.box(), c.seed, c.camera, 4.0f / 3);
  const Looked looked(s, c.form);
  const render::Pixel by_texture = sample.tracer().pixel(camera, nullptr, options, c.x, c.y),
                      by_maps = sample.tracer().pixel(camera, &looked, options, c.x, c.y);
  if (by_texture.primary == by_maps.primary && by_texture.lit == by_maps.lit)
    return Finding{std::uint64_t{by_maps.primary.triangle} + 2 * by_maps.by_primary.shader + by_maps.lit};
  return wrong(text_of(by_texture), text_of(by_maps));
}

// ---------------------------------------------------------------------------------------------------------------------
// What goes wrong
// ---------------------------------------------------------------------------------------------------------------------

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
  Law law{
      .id = "traverse.same_image",
      .topic = "traverse",
      .says =
          "rays that ask micromaps first, and the texture where these do not know, meet the same triangles "
          "at the "
          "same t, and the same light, as rays that ask the texture alone: with special indices only, flat "
          "maps, "
          "the paper's tree, the ranked tree, VQ2 and VQ4",
      .source = "Succinct Opacity Micromaps, 5.2; Compressed Opacity Maps, figures 1 and 12",
      .method = proofs::Method::sample,
      .subjects = {"traverse"},
      .at_once = "levels 0..5",
      .fast_seconds = 1.5,
      .domain =
          [](const Subject&, Level) {
            return fmt::format(
                "{} x {} pixels of cameras on a random path through a world of our own, a primary ray and "
                "a shadow ray each, by {} forms of its maps",
                picture_width, picture_height, forms().size());
          },
      .unfit = [](const Subject& s, Level n) -> std::optional<std::string> {
        if (auto why = needing({entry::look})(s, n)) return why;
        if (!render::has_embree()) return render::embree_text();
        return std::nullopt;
      },
      .mutants =
          {
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
      {case_count,
       [](const Subject& s, Level, std::uint64_t k, const Run& run) {
         return check(of_traverse(s), numbered(k, run));
       },
       [](const Subject&, Level, std::uint64_t k, const Run& run) { return text_of(numbered(k, run)); },
       [](const Subject& s, Level, const std::string& at) { return check(of_traverse(s), read(at)); },
       picture_width * forms().size(), Kind::interior})};
}

}  // namespace mmverify::proofs::traverse
