// The baking of the built-in subjects.
#include "impl/attribute/bake/codes.hpp"
#include "impl/attribute/error.hpp"
#include "impl/attribute/plan.hpp"
#include "proofs/attribute/bake/truth.hpp"
#include "proofs/attribute/subject_parts.hpp"
#include "proofs/points/point.hpp"
#include "spec/attribute/error.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;
namespace fast = impl::attribute;

template <class Q, class Texture>
ChannelError channel_error(const BakeCase& one, Level n, MapForm form, const std::vector<Rgba>& map,
                           std::size_t c, const Texture& texture) {
  const auto uv = base_triangle<Q>(one.uv);
  const auto number = [&](const Rgba& codes) { return number_of<Q>(one.picture, c, codes[c]); };
  const auto shown = [&](const slow::Vertex& at) {
    return number(map[slow::vertex_index(slow::VertexOrder::w_minor, at, n)]);
  };
  Q largest(0), square(0);
  for (std::uint32_t k = 0; k < slow::face_count(n); ++k) {
    const auto here = form == MapForm::faces ? slow::face_error(texture, uv, n, k, number(map[k]))
                                             : slow::vertex_error(texture, uv, n, k, shown);
    largest = std::max(largest, here.largest);
    square += here.square;
  }
  return {wide(largest), wide(square) / Rational(slow::face_count(n))};
}

std::array<ChannelError, 4> specified_error(const BakeCase& one, Level n, MapForm form,
                                            const std::vector<Rgba>& map) {
  std::array<ChannelError, 4> error;
  const auto judge = [&](std::size_t c, const auto& texture) {
    error[c] = in_few_bits([&]<class Q>() { return channel_error<Q>(one, n, form, map, c, texture); });
  };
  for (std::size_t c = 0; c < 4; ++c)
    if (one.picture.meaning == Meaning::srgb && c < 3)
      judge(c, channel_of<slow::Srgb8>(one.picture, c, Filter::bilinear));
    else
      judge(c, channel_of<std::uint8_t>(one.picture, c, Filter::bilinear));
  return error;
}

Rational specified_mean(const BakeCase& one, Level n, std::size_t c, std::uint32_t index) {
  const auto mean = [&](const auto& texture) {
    return in_few_bits(
        [&]<class Q>() { return wide(slow::face_value(texture, base_triangle<Q>(one.uv), n, index)); });
  };
  const Picture& p = one.picture;
  return p.meaning == Meaning::srgb && c < 3 ? mean(channel_of<slow::Srgb8>(p, c, p.filter))
                                             : mean(channel_of<std::uint8_t>(p, c, p.filter));
}

/// A plan by the specification's distances and by trial: each triangle has the least graded level, and wants one
/// level more if it does not keep its error.
std::vector<PlannedTriangle> specified_plan(const PlanCase& one) {
  const std::size_t count = one.neighbours.size();
  std::vector<Neighbours> around = one.neighbours;
  for (std::size_t t = 0; t < count; ++t)
    for (std::int32_t& s : around[t])
      if (one.special[t] || (s >= 0 && one.special[static_cast<std::size_t>(s)])) s = slow::no_neighbour;
  std::vector<Level> wanted(count, 0);
  for (std::size_t t = 0; t < count; ++t)
    while (!one.special[t] && wanted[t] < one.highest && !one.keeps(t, wanted[t], 0)) ++wanted[t];
  for (;;) {
    const std::vector<Level> levels = slow::graded(wanted, around);
    std::vector<PlannedTriangle> plan(count);
    bool raised = false;
    for (std::size_t t = 0; t < count && !raised; ++t) {
      if (one.special[t]) continue;
      const std::uint8_t flags = slow::decimated_edges(levels, around[t], t);
      plan[t] = {levels[t], flags, one.keeps(t, levels[t], flags)};
      if (plan[t].kept) continue;
      if (flags != 0 && one.keeps(t, levels[t], 0)) {
        for (std::size_t k = 0; k < 3; ++k)
          if ((flags >> k & 1) != 0) wanted[static_cast<std::size_t>(around[t][k])] = levels[t];
        raised = true;
      } else if (levels[t] < one.highest) {
        wanted[t] = levels[t] + 1;
        raised = true;
      }
    }
    if (!raised) return plan;
  }
}

/// A picture in the library's form.
template <class Channel>
struct Taken {
  fast::RgbaViewOf<Channel> view;
  fast::AttributeSamplingOf<Channel> sampling;
  fast::BaseTriangle uv;

  explicit Taken(const BakeCaseOf<Channel>& one) {
    const auto& p = one.picture;
    view = {p.texels.data()->data(), p.width, p.height, p.width};
    sampling.u = static_cast<fast::Wrap>(p.wrap_u);
    sampling.v = static_cast<fast::Wrap>(p.wrap_v);
    sampling.filter = static_cast<fast::Filter>(p.filter);
    sampling.meaning = static_cast<fast::Meaning>(p.meaning);
    sampling.border = p.border;
    for (std::size_t k = 0; k < 3; ++k) uv[k] = {one.uv[2 * k], one.uv[2 * k + 1]};
  }
};
static_assert(sizeof(Rgba) == 4 && sizeof(RgbaOf<std::uint16_t>) == 8, "texels are taken as channels");

template <class Channel>
Bakers<Channel> specified_bakers() {
  const auto of = [](MapForm form) -> MapBakerOf<Channel> {
    return [=](const BakeCaseOf<Channel>& one, Level n) { return true_map(form, one, n); };
  };
  return {of(MapForm::vertices), of(MapForm::faces)};
}

template <class Channel>
Bakers<Channel> library_bakers() {
  const auto of = [](MapForm form) -> MapBakerOf<Channel> {
    return [=](const BakeCaseOf<Channel>& one, Level n) {
      const Taken<Channel> taken(one);
      std::vector<RgbaOf<Channel>> map(map_size(form, n));
      const fast::AttributeBakerOf<Channel> baker(taken.view, taken.sampling);
      if (form == MapForm::faces)
        baker.faces(taken.uv, n, map);
      else
        baker.vertices(taken.uv, n, map);
      return map;
    };
  };
  return {of(MapForm::vertices), of(MapForm::faces)};
}

}  // namespace

Baking specified_baking() {
  Baking f;
  f.vertices = true_vertices;
  f.faces = true_faces;
  f.wide = specified_bakers<std::uint16_t>();
  f.floats = specified_bakers<float>();
  f.face_mean = specified_mean;
  f.error = specified_error;
  f.light = [](std::uint32_t m) { return slow::light_table()[m]; };
  f.plan = specified_plan;
  return f;
}

Baking library_baking() {
  Baking f;
  const Bakers<std::uint8_t> bakers = library_bakers<std::uint8_t>();
  f.vertices = bakers.vertices;
  f.faces = bakers.faces;
  f.wide = library_bakers<std::uint16_t>();
  f.floats = library_bakers<float>();
  f.error = [](const BakeCase& one, Level n, MapForm form, const std::vector<Rgba>& map) {
    const Taken taken(one);
    const fast::MapError error =
        fast::map_error(taken.view, taken.sampling, taken.uv, n,
                        form == MapForm::faces ? fast::MapForm::faces : fast::MapForm::vertices, map);
    std::array<ChannelError, 4> exactly;
    for (std::size_t c = 0; c < 4; ++c)
      exactly[c] = {points::rational(error.largest[c]), points::rational(error.square[c])};
    return exactly;
  };
  f.slack = 0x1p-20;
  f.light = [](std::uint32_t m) {
    const auto& curve = fast::detail::Curve::srgb();
    return static_cast<std::uint32_t>(m % 2 == 0 ? curve.number[m / 2] : curve.twice_least[(m + 1) / 2] / 2);
  };
  f.plan = [](const PlanCase& one) {
    std::vector<fast::Neighbours> neighbours(one.neighbours.begin(), one.neighbours.end());
    fast::PlanRequest request;
    request.neighbours = neighbours;
    request.highest = one.highest;
    request.special = [&](std::size_t t) { return one.special[t]; };
    request.keeps = one.keeps;
    std::vector<PlannedTriangle> planned;
    for (const fast::TrianglePlan& p : fast::plan(request)) planned.push_back({p.level, p.decimated, p.kept});
    return planned;
  };
  return f;
}

}  // namespace mmverify::proofs::attribute
