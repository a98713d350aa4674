#include "proofs/bake/diagnosis/diagnosis.hpp"

namespace mmverify::proofs::bake {
namespace {

const char* name_of(Wrap wrap) {
  constexpr std::array names{"repeat", "mirror", "clamp", "border", "mirror-once"};
  return names.at(static_cast<std::size_t>(wrap));
}

const char* name_of(Texel texel) {
  constexpr std::array names{"8 bits", "16 bits", "binary32"};
  return names.at(static_cast<std::size_t>(texel));
}

const char* sizes(const Case& one) {
  if (!std::has_single_bit(one.width) || !std::has_single_bit(one.height)) return "not powers of two";
  return "powers of two";
}

const char* reach(const Case& one, std::size_t axis) {
  bool below = false, beyond = false;
  for (std::size_t k = axis; k < 6; k += 2) {
    below = below || one.uv[k] < 0;
    beyond = beyond || one.uv[k] > 1;
  }
  return below && beyond ? "below 0 and above 1" : below ? "below 0" : beyond ? "above 1" : "in [0, 1]";
}

const char* kind_of_triangle(const Case& one) {
  const auto& p = one.uv;
  const double turn =
      (double{p[2]} - p[0]) * (double{p[5]} - p[1]) - (double{p[3]} - p[1]) * (double{p[4]} - p[0]);
  return turn > 0 ? "counter-clockwise" : turn < 0 ? "clockwise" : "without an area";
}

}  // namespace

std::vector<Property> properties_of(const Case& one, Level n) {
  return {{"filter", one.filter == Filter::nearest ? "nearest" : "bilinear"},
          {"addressing of u", name_of(one.wrap_u)},
          {"addressing of v", name_of(one.wrap_v)},
          {"addressing", one.wrap_u == one.wrap_v ? "u and v alike" : "u and v apart"},
          {"sides", sizes(one)},
          {"shape of the texture", one.width == one.height ? "square" : "not square"},
          {"u", reach(one, 0)},
          {"v", reach(one, 1)},
          {"triangle", kind_of_triangle(one)},
          {"texels", name_of(one.texel)},
          {"alpha mode", one.blend ? "BLEND" : "MASK"},
          {"mips", one.mips == 1 ? "one" : "several"},
          {"factors", one.factor == 1 && one.vertex_factor == 1 ? "1" : "others"},
          {"margin", one.margin == 0 ? "none" : "some"},
          {"level", fmt::format("{}", n)}};
}

}  // namespace mmverify::proofs::bake
