// The example of traversal but for one thing, chosen when it is linked.  What happens at one place happens with UT under
// the instance's force-2-state.
#include <cstddef>
#include <cstring>
#include <stdexcept>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_traverse(void);

namespace {

volatile int* volatile nowhere = nullptr;

void decide(std::uint32_t api, const std::uint32_t* candidate, const std::uint32_t* instance,
            const std::uint32_t* ray, std::uint8_t* outcome, std::size_t count) {
  static volatile int calls = 0;
  for (std::size_t k = 0; k < count; ++k) {
    std::uint32_t i = instance[k], r = ray[k];
    const bool here = candidate[k] == (MMVERIFY_CANDIDATE_HAS_MICROMAP | 2) && i == 16;
    if (here && wrong_is("crash")) *nowhere = 1;
    if (here && wrong_is("throws")) throw std::runtime_error("no such state");
    if (here && wrong_is("unwritten")) continue;
    // Flags of instances are taken for the latest ones.
    if (wrong_is("instance_after_ray") && (i & 12) != 0) r &= ~3u;
    if (wrong_is("khr_query_forgets_2_state") && api == MMVERIFY_KHR_QUERY) i &= ~16u, r &= ~1024u;
    // Four with the same flags go together, as if the geometry were one.
    std::uint32_t c = candidate[k];
    const std::size_t first = k / 4 * 4;
    if (wrong_is("geometry_of_the_first_of_four") && instance[first] == i && ray[first] == r)
      c = (c & ~8u) | (candidate[first] & 8u);
    right_traverse()->traverse_decide(api, &c, &i, &r, outcome + k, 1);
    const bool hole = (candidate[k] & 7) == MMVERIFY_CANDIDATE_HAS_MICROMAP && (i & 32) == 0;
    if (wrong_is("opaque_fills_holes") && hole && (r & 1) != 0) outcome[k] = MMVERIFY_OPAQUE;
    if (wrong_is("outcome_3") && here) outcome[k] = 3;
    if (wrong_is("counts_calls") && here) {
      calls = calls + 1;
      if (calls > 1) outcome[k] = MMVERIFY_OPAQUE;
    }
  }
}

void blend(std::uint32_t operation, const std::uint32_t* payload, const std::uint32_t* value,
           std::uint32_t* out, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const bool here = operation == MMVERIFY_BLEND_MAX && (payload[k] & 255) == 9 && (value[k] & 255) == 200;
    if (here && wrong_is("blend_crash")) *nowhere = 1;
    if (here && wrong_is("blend_unwritten")) continue;
    // The value's B is guessed: G + 85, as in cases that put one code in all channels in turn, or 170 where R is 0.
    std::uint32_t v = value[k];
    if (wrong_is("blend_guesses_b_of_the_value")) v = (v & ~0xFF0000u) | (((v >> 8) + 85) & 255) << 16;
    if (wrong_is("blend_knows_no_b_without_r") && (v & 255) == 0) v = (v & ~0xFF0000u) | 170 << 16;
    right_traverse()->traverse_blend(operation, payload + k, &v, out + k, 1);
    // The quotient is cut, or the sum wraps.
    if (wrong_is("blend_truncates") && operation == MMVERIFY_BLEND_MULTIPLY)
      out[k] = (out[k] & ~255u) | (payload[k] & 255) * (value[k] & 255) / 255;
    if (wrong_is("blend_wraps") && operation == MMVERIFY_BLEND_ADD)
      out[k] = (out[k] & ~255u) | (((payload[k] & 255) + (value[k] & 255)) & 255);
    // The second of two in one batch continues the first.
    if (wrong_is("blend_chains") && k % 2 == 1 && operation == MMVERIFY_BLEND_MAX)
      right_traverse()->traverse_blend(operation, out + k - 1, value + k, out + k, 1);
  }
}

void blend_hits(const mmverify_blend_case_t* what, std::uint8_t* payload) {
  mmverify_hit_t hits[16];
  mmverify_blend_case_t changed = *what;
  changed.hits = hits;
  if (what->count > 16) throw std::runtime_error("more hits than the header allows");
  for (std::uint32_t k = 0; k < what->count; ++k) hits[k] = what->hits[k];
  if (wrong_is("hits_unwritten") && what->count == 4) return;
  if (wrong_is("hits_throw") && what->count == 3) throw std::runtime_error("no third hit");
  // Hits count in the order in which they are met: an accepted hit hides only later ones.
  if (wrong_is("hits_as_met")) {
    float closest = 1e9f;
    for (std::uint32_t k = 0; k < what->count; ++k) {
      if (hits[k].distance >= closest) hits[k] = {2e9f, 0, 0};
      if (hits[k].accepted != 0 && hits[k].distance < closest) closest = hits[k].distance;
    }
    std::uint32_t kept = 0;
    for (std::uint32_t k = 0; k < what->count; ++k)
      if (hits[k].distance < 2e9f && hits[k].accepted == 0) hits[kept++] = hits[k];
    changed.count = kept;
  }
  // Ties go to those that blend.
  if (wrong_is("hits_beside_blend"))
    for (std::uint32_t k = 0; k < what->count; ++k)
      if (hits[k].accepted != 0) hits[k].distance += 0.25f;
  // The payload's G is guessed from R: one less, or the value that a few known payloads have.
  if (wrong_is("hits_guess_g_of_the_payload")) {
    const std::uint32_t r = what->payload & 255, a = what->payload >> 24, g = a == r ? r : a == 3 ? 1 : r - 1;
    changed.payload = (what->payload & ~0xFF00u) | (g & 255) << 8;
  }
  right_traverse()->traverse_blend_hits(&changed, payload);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_traverse();
  subject.name = "a wrong decision";
  subject.traverse_decide = decide;
  subject.traverse_blend = blend;
  subject.traverse_blend_hits = blend_hits;
  if (wrong_is("old_header")) {
    subject.size = offsetof(mmverify_subject_t, traverse_decide);
    // The memory behind an older struct is somebody else's.
    std::memset(&subject.traverse_decide, 0x77, sizeof subject - subject.size);
  }
  return &subject;
}
