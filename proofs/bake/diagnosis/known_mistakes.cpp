#include <algorithm>

#include "proofs/bake/diagnosis/diagnosis.hpp"
#include "proofs/bake/mutants/states.hpp"

namespace mmverify::proofs::bake {
namespace {

void turn_rows(Case& one) {
  auto from = one.alpha.begin();
  for (std::uint32_t k = 0; k < one.mips; ++k) {
    const std::ptrdiff_t width = std::max(1u, one.width >> k), height = std::max(1u, one.height >> k);
    for (std::ptrdiff_t low = 0, high = height - 1; low < high; ++low, --high)
      std::swap_ranges(from + low * width, from + (low + 1) * width, from + high * width);
    from += width * height;
  }
}

void turn_v(Case& one) {
  for (std::size_t k = 1; k < 6; k += 2) one.uv[k] = 1 - one.uv[k];
}

void turn_u(Case& one) {
  for (std::size_t k = 0; k < 6; k += 2) one.uv[k] = 1 - one.uv[k];
}

void negate_v(Case& one) {
  for (std::size_t k = 1; k < 6; k += 2) one.uv[k] = -one.uv[k];
}

void turn_vertices(Case& one) { std::rotate(one.uv.begin(), one.uv.begin() + 2, one.uv.end()); }
void turn_vertices_twice(Case& one) { std::rotate(one.uv.begin(), one.uv.begin() + 4, one.uv.end()); }

void exchange_axes(Case& one) {
  for (std::size_t k = 0; k < 6; k += 2) std::swap(one.uv[k], one.uv[k + 1]);
}

void exchange_vertices(Case& one) {
  std::swap(one.uv[2], one.uv[4]);
  std::swap(one.uv[3], one.uv[5]);
}

void move_by_texels(Case& one, float by) {
  for (std::size_t k = 0; k < 6; k += 2) {
    one.uv[k] += by / static_cast<float>(one.width);
    one.uv[k + 1] += by / static_cast<float>(one.height);
  }
}

void clamp_all(Case& one) { one.wrap_u = one.wrap_v = Wrap::clamp_to_edge; }
void repeat_all(Case& one) { one.wrap_u = one.wrap_v = Wrap::repeat; }
void half_cutoff(Case& one) { one.cutoff = {1, 2}; }
void blend_by_cutoff(Case& one) {
  if (one.blend) one.cutoff = {1, 2};
  one.blend = false;
}
void nothing(Case&) {}

}  // namespace

const std::vector<KnownMistake>& known_mistakes() {
  static const std::vector<KnownMistake> all{
      {"rows of texels came from below", turn_rows},
      {"v were 1 - v", turn_v},
      {"v were -v", negate_v},
      {"u were 1 - u", turn_u},
      {"u and v were exchanged", exchange_axes},
      {"the second and the third vertex were exchanged", exchange_vertices},
      {"the vertices were turned by one", turn_vertices},
      {"the vertices were turned by two", turn_vertices_twice},
      {"texel centres lay at whole numbers, not at halves", [](Case& c) { move_by_texels(c, 0.5f); }},
      {"texel centres lay a whole texel on", [](Case& c) { move_by_texels(c, -0.5f); }},
      {"v were addressed as u is", [](Case& c) { c.wrap_v = c.wrap_u; }},
      {"u were addressed as v is", [](Case& c) { c.wrap_u = c.wrap_v; }},
      {"u and v had each other's addressing", [](Case& c) { std::swap(c.wrap_u, c.wrap_v); }},
      {"all addressing were clamp", clamp_all},
      {"all addressing were repeat", repeat_all},
      {"mirror-once were clamp", mirror_once_as_clamp},
      {"the filter were the other one", other_filter},
      {"the cutoff were always 1/2", half_cutoff},
      {"alpha mode BLEND were MASK with a cutoff of 1/2", blend_by_cutoff},
      {"alpha mode MASK were BLEND", [](Case& c) { c.blend = true; }},
      {"the factors were 1", [](Case& c) { c.factor = c.vertex_factor = 1; }},
      {"the vertices' factor were 1", without_vertex_factor},
      {"there were the first mip alone", first_mip_alone},
      {"there were no margin", [](Case& c) { c.margin = 0; }},
      {"the border were 0", [](Case& c) { c.border = 0; }},
      {"T and O were exchanged", nothing, {State::O, State::T, State::UT, State::UO}},
      {"the two bits of each state were exchanged", nothing, {State::T, State::UT, State::O, State::UO}},
      {"all bits of states were inverted", nothing, {State::UO, State::UT, State::O, State::T}},
  };
  return all;
}

}  // namespace mmverify::proofs::bake
