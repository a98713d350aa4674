// Topic traverse, what rays ask: states of the sample world's flat maps, found by halving the triangle, and what hits
// blend to.
// Source: Succinct Opacity Micromaps, 4.3; Vulkan, the table of special indices.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "proofs/traverse/rays/sample_world.hpp"
#include "proofs/traverse/subject.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::traverse;

/// Children 0, 2 and 3 lie at the three corners, child 1 between them. Child 3 exchanges the first two corners, child 1
/// has them in the order of the sides across from the second, the first, the third.
std::uint32_t index_of(double u, double v, unsigned level, Fault wrong) {
  std::uint32_t index = 0;
  double a = 1 - u - v, b = u, c = v;
  for (unsigned k = 0; k < level; ++k) {
    std::uint32_t digit = 1;
    if (a >= 0.5) {
      digit = 0;
      a = 2 * a - 1, b = 2 * b, c = 2 * c;
    } else if (b >= 0.5) {
      digit = 2;
      a = 2 * a, b = 2 * b - 1, c = 2 * c;
    } else if (c >= 0.5) {
      digit = 3;
      const double exchanged = 2 * a;
      a = 2 * b, b = exchanged, c = 2 * c - 1;
    } else {
      const double across = 1 - 2 * a;
      a = 1 - 2 * b, b = across, c = 1 - 2 * c;
      if (wrong == "middle_is_not_turned"_fault) std::swap(a, b);
    }
    index = wrong == "digits_from_the_last"_fault ? index | digit << (2 * k) : index << 2 | digit;
  }
  return index;
}

std::optional<State> look(const Looks& asks, Fault wrong) {
  // Square maps are left to the texture, which is right of any.
  if (!render::has_levels(asks.method)) return std::nullopt;
  const render::Micromaps& maps = SampleWorld::get().micromaps(asks.level);
  const auto& codes = maps.codes[asks.geometry];
  if (codes.empty()) return std::nullopt;
  std::uint32_t triangle = asks.triangle;
  if (wrong == "map_of_the_triangle_before"_fault && triangle != 0) --triangle;
  const std::uint32_t code = codes[triangle];
  if (code >= 0xfffffffc) {
    const std::uint32_t special = 0xffffffff - code;
    return static_cast<State>(wrong == "specials_from_zero"_fault ? (special + 3) % 4 : special);
  }
  if (asks.method == render::Method::special) return std::nullopt;
  const auto& record = maps.array.records[code];
  const std::uint32_t k = index_of(double{asks.at.u}, double{asks.at.v}, record.level, wrong);
  const unsigned place = wrong == "highest_bits_first"_fault ? 3 - k % 4 : k % 4;
  unsigned state = maps.array.data[record.offset + k / 4] >> (2 * place) & 3u;
  if (wrong == "unknown_transparent_is_ignored"_fault && state == 2) state = 0;
  return static_cast<State>(state);
}

/// Channel by channel: what lies before the accepted hit, by the operation's own words.
spec::traverse::Colour gather(Operation o, spec::traverse::Colour payload, std::span<const Hit> hits,
                              Fault wrong) {
  std::uint32_t end = 0xffffffff, blended = 0;
  for (const Hit& h : hits)
    if (h.accepted && wrong != "all_that_were_met"_fault && h.distance < end) end = h.distance;
  for (const Hit& h : hits) {
    if (h.accepted || h.distance >= end) continue;
    if (++blended > 1 && wrong == "one_alone"_fault) break;
    for (std::size_t c = 0; c < (wrong == "without_alpha"_fault ? 3u : 4u); ++c) {
      std::uint32_t& p = payload[c];
      const std::uint32_t v = h.value[c];
      if (o == Operation::add)
        p = wrong == "above_255"_fault ? (p + v) % 256 : p + v > 255 ? 255 : p + v;
      else if ((v > p) == (o == Operation::max))
        p = v;
    }
  }
  return payload;
}

InsideFault row(const char* law, const char* name, const char* what) {
  Functions functions;
  functions.look = [wrong = named(name)](const Looks& asks) { return look(asks, wrong); };
  functions.gather = [wrong = named(name)](Operation o, const spec::traverse::Colour& payload,
                                           std::span<const Hit> hits) {
    return gather(o, payload, hits, wrong);
  };
  return {law,
          name,
          what,
          std::make_shared<TraverseSubject>(name, "of another hand", std::move(functions)),
          {0, 0}};
}
constexpr char image[] = "traverse.same_image", payload[] = "traverse.same_payload";

}  // namespace

InsideRows inside_faults_of_rays() {
  if (!render::has_embree()) return {};
  return {
      row(image, "unknown_transparent_is_ignored", "UT is read as T"),
      row(image, "digits_from_the_last", "the index has its last digit first"),
      row(image, "highest_bits_first", "a byte's first state is in its highest bits"),
      row(image, "map_of_the_triangle_before", "each triangle but the first has the map before its own"),
      row(image, "middle_is_not_turned", "the middle child is not turned"),
      row(image, "specials_from_zero", "special indices are counted from -2 on"),
      row(payload, "all_that_were_met", "hits behind the accepted one stay blended"),
      row(payload, "one_alone", "the first hit met is blended alone"),
      row(payload, "above_255", "sums above 255 begin anew"),
      row(payload, "without_alpha", "alpha is not blended"),
  };
}

InsideRows inside_right_of_rays() {
  if (!render::has_embree()) return {};
  return {row(image, "by_halving", ""), row(payload, "by_halving_and_channels", "")};
}

}  // namespace mmverify::tests::foreign
