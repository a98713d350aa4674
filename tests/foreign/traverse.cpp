// The decision of a traversal, written from the header and docs/TRAVERSE.md alone: each step is a list of who has a say, and
// the last who has one is heard.  Of blending, from the header alone.  Each fault of the table is one slip inside this code.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/fault.hpp"

namespace {

using mmverify::tests::foreign::chosen_fault;
using mmverify::tests::foreign::threading;

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/traverse_faults.def"
#undef MMVERIFY_FAULT
};

constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/traverse_faults.def"
#undef MMVERIFY_FAULT
};

const std::optional<int> fault = chosen_fault(fault_names);
bool has(Fault f) { return fault == f; }

/// The words of one candidate, taken apart.
struct Seen {
  unsigned api, state;
  bool micromap, geometry_opaque;
  bool instance_opaque, instance_no_opaque, instance_two, disabled;
  bool ray_opaque, ray_no_opaque, cull_opaque, cull_no_opaque, ray_two;
};

Seen seen(std::uint32_t api, std::uint32_t candidate, std::uint32_t instance, std::uint32_t ray) {
  Seen s{};
  s.api = api;
  s.state = candidate % 4;
  s.micromap = candidate / 4 % 2 != 0;
  s.geometry_opaque = candidate / 8 % 2 != 0;
  s.instance_opaque = instance / 4 % 2 != 0;
  s.instance_no_opaque = instance / 8 % 2 != 0;
  s.instance_two = instance / 16 % 2 != 0;
  s.disabled = instance / 32 % 2 != 0;
  s.ray_opaque = ray % 2 != 0;
  s.ray_no_opaque = ray / 2 % 2 != 0;
  s.cull_opaque = ray / 64 % 2 != 0;
  s.cull_no_opaque = ray / 128 % 2 != 0;
  s.ray_two = ray / (has(two_state_is_one_bit_late) ? 2048 : 1024) % 2 != 0;
  if (has(two_state_of_the_instance_alone)) s.ray_two = false;
  if (has(two_state_wants_both)) s.instance_two = s.ray_two = s.instance_two && s.ray_two;
  if (has(culls_are_exchanged)) {
    const bool keep = s.cull_opaque;
    s.cull_opaque = s.cull_no_opaque;
    s.cull_no_opaque = keep;
  }
  if (has(dxr_queries_skip_cull) && api == MMVERIFY_DXR_QUERY) s.cull_opaque = s.cull_no_opaque = false;
  if (has(khr_queries_skip_micromaps) && api == MMVERIFY_KHR_QUERY) s.micromap = false;
  if (has(ext_pipelines_have_no_force) && api == MMVERIFY_EXT_PIPELINE && !s.ray_opaque)
    s.instance_no_opaque = false;
  return s;
}

enum Answer : std::uint8_t { drop = MMVERIFY_IGNORED, take = MMVERIFY_OPAQUE, ask = MMVERIFY_NON_OPAQUE };

Answer culled(const Seen& s, Answer a) {
  if (s.cull_opaque && a == take) return drop;
  if (s.cull_no_opaque && a == ask) {
    if (has(cull_no_opaque_spares_forced) && s.instance_no_opaque) return ask;
    return drop;
  }
  return a;
}

/// Rows: T, O, UT, UO; columns: without and with force-2-state.
constexpr Answer table[4][2] = {{drop, drop}, {take, take}, {ask, drop}, {ask, take}};

Answer looked_up(const Seen& s) {
  const bool two = s.instance_two || s.ray_two, unknown = s.state > 1;
  if (has(holes_of_opaque_geometries) && s.state == 0 && s.geometry_opaque) return take;
  if (has(ut_is_ignored) && s.state == 2) return drop;
  if (has(ut_is_dropped_under_no_opaque) && s.ray_no_opaque && unknown && !two && s.state == 2) return drop;
  if (has(uo_is_opaque) && s.state == 3) return take;
  if (has(two_state_reads_uo_as_transparent) && s.state == 3 && s.instance_two && s.ray_two) return drop;
  if (has(unknown_by_the_geometry) && unknown && !two) return s.geometry_opaque ? take : ask;
  return table[s.state][two];
}

std::uint8_t decided(const Seen& s) {
  Answer a = s.geometry_opaque ? take : ask;
  const bool counts = s.micromap && !s.disabled;
  if (has(state_without_micromap) && !s.micromap && s.state == 0 && s.ray_two) a = drop;
  if (has(disabled_counts_for_unknown) && s.micromap && s.disabled && s.state == 3) a = ask;
  if (counts) {
    a = looked_up(s);
    const bool comes_back =
        has(ignored_by_the_ray_is_not_final) && s.state == 2 && !s.instance_two && s.instance_opaque;
    if (a == drop && !comes_back) return drop;
  }
  if (has(cull_before_overrides) && (s.instance_opaque || s.instance_no_opaque)) {
    a = culled(s, a);
    if (a == drop) return drop;
  }
  const struct {
    bool says;
    Answer what;
  } heard[] = {{s.instance_opaque, take},
               {s.instance_no_opaque, ask},
               {s.ray_opaque && !(has(opaque_leaves_unknown) && counts && a == ask), take},
               {s.ray_no_opaque, ask},
               {has(instance_last) && s.instance_opaque, take},
               {has(instance_last) && s.instance_no_opaque, ask}};
  for (const auto& one : heard)
    if (one.says) a = one.what;
  return culled(s, a);
}

void decide(std::uint32_t api, const std::uint32_t* candidate, const std::uint32_t* instance,
            const std::uint32_t* ray, std::uint8_t* outcome, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k / 8 * 8, last = first + 7;
    const bool alike = has(eight_by_their_ends) && last < count && instance[first] == instance[last] &&
                       ray[first] == ray[last];
    const std::size_t of = alike ? first : k;
    outcome[k] = decided(seen(api, candidate[k], instance[of], ray[of]));
  }
}

// Fixed functions: a code is a fraction of 255, and a hit a function of fractions.

/// a b / 255 to the nearest whole number, by long division.
unsigned of_255(unsigned a, unsigned b) {
  const unsigned whole = a * b / 255, rest = a * b % 255;
  if (has(products_are_rounded_down)) return whole;
  return whole + (rest > 127 ? 1 : 0);
}

unsigned one_code(std::uint32_t operation, unsigned p, unsigned v, unsigned alpha) {
  const auto most_255 = [](unsigned x) { return x > 255 ? 255 : x; };
  switch (operation) {
    case MMVERIFY_BLEND_MAX:
      if (has(max_leaves_black) && p == 0 && v < 4) return p;
      if (has(max_of_equals_is_more) && p == v && p < 255) return p + 1;
      return v > p ? v : p;
    case MMVERIFY_BLEND_MIN:
      if (has(min_ignores_a_step) && v + 1 == p) return p;
      if (has(min_of_equals_is_half) && p == v) return p / 2;
      return v < p ? v : p;
    case MMVERIFY_BLEND_ADD:
      if (has(sums_stop_at_254) && p + v > 254) return 254;
      if (has(sums_from_the_payload) && p > 127 && v > 127) return p;
      return most_255(p + v);
    case MMVERIFY_BLEND_MULTIPLY:
      if (has(product_of_equals_is_one_of_them) && p == v) return p;
      return of_255(p, v);
    default:
      if (has(over_of_plain_values)) v = of_255(v, alpha);
      return most_255(v + of_255(p, 255 - alpha));
  }
}

std::uint32_t one_word(std::uint32_t operation, std::uint32_t payload, std::uint32_t value) {
  std::uint32_t out = 0;
  for (unsigned c = 4; c-- > 0;) {
    const unsigned p = payload >> (8 * c) & 0xFF, v = value >> (8 * c) & 0xFF, alpha = value >> 24;
    out = out << 8 | (has(alpha_is_kept) && c == 3 ? p : one_code(operation, p, v, alpha));
  }
  return out;
}

void blend(std::uint32_t operation, const std::uint32_t* payload, const std::uint32_t* value,
           std::uint32_t* out, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) out[k] = one_word(operation, payload[k], value[k]);
}

/// A distance as it is compared.
double known_distance(float distance) {
  if (has(distances_in_thousandths)) return std::floor(static_cast<double>(distance) * 1000);
  if (!has(distances_of_24_bits)) return static_cast<double>(distance);
  std::uint32_t bits;
  std::memcpy(&bits, &distance, sizeof bits);
  return bits >> 8;
}

std::uint32_t counted(const mmverify_blend_case_t& what) {
  return has(eight_hits_at_most) && what.count > 8 ? 8 : what.count;
}

/// Whether an accepted hit takes the place of hit k.
bool hidden(const mmverify_blend_case_t& what, std::uint32_t k) {
  const double here = known_distance(what.hits[k].distance);
  for (std::uint32_t a = 0; a < counted(what); ++a) {
    if (what.hits[a].accepted == 0) continue;
    if (has(only_later_hits_are_hidden) && a > k) continue;
    const double there = known_distance(what.hits[a].distance);
    if (there < here) return true;
    if (there == here && !has(beside_is_not_behind)) return true;
  }
  return false;
}

void blend_hits(const mmverify_blend_case_t* what, std::uint8_t* payload) {
  std::uint32_t word = what->payload;
  for (std::uint32_t n = 0; n < counted(*what); ++n) {
    const std::uint32_t k = has(hits_from_the_last) ? what->count - 1 - n : n;
    const bool again = k > 0 && what->hits[k].distance == what->hits[k - 1].distance;
    if (has(a_hit_like_the_last_is_dropped) && again && what->hits[k].value == what->hits[k - 1].value)
      continue;
    if (has(one_hit_a_distance) && again && what->hits[k - 1].accepted == 0) continue;
    if (what->hits[k].accepted == 0 && !hidden(*what, k))
      word = one_word(what->operation, word, what->hits[k].value);
  }
  for (unsigned c = 0; c < 4; ++c) payload[c] = static_cast<std::uint8_t>(word >> (8 * c) & 0xFF);
}

mmverify_subject_t make() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "foreign traversal";
  s.flags = threading();
  s.traverse_decide = decide;
  s.traverse_blend = blend;
  s.traverse_blend_hits = blend_hits;
  return s;
}

const mmverify_subject_t subject = make();

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) { return fault ? &subject : nullptr; }
