// A map, from the whole triangle down to its micro-triangles.
#include "tests/foreign/bake/baker.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

#include "tests/foreign/bake/faults.hpp"
#include "tests/foreign/bake/mips.hpp"
#include "tests/foreign/bake/placed.hpp"
#include "tests/foreign/bake/sampled.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

constexpr unsigned transparent = 0, opaque = 1, unknown = 2;

template <class T>
class Baker {
 public:
  Baker(const mmverify_bake_case_t& c, const std::vector<Mip>& mips, std::uint8_t* map)
      : case_(c), mips_(mips), map_(map) {
    for (unsigned k = 0; k < mips.size(); ++k) {
      const bool nearest = c.filter == MMVERIFY_NEAREST || (has(mips_nearest) && k > 0);
      sampled_.emplace_back(c, mips[k], k, nearest);
    }
    std::size_t m = 0;
    if (has(centroid_of_second_mip)) m = std::min<std::size_t>(1, mips.size() - 1);
    if (has(centroid_of_last_mip) && mips.size() >= 3) m = mips.size() - 1;
    centre_mip_ = m;
    is_point_ = std::all_of(c.uv, c.uv + 6, [&](const float& x) { return x == c.uv[(&x - c.uv) % 2]; });
  }

  void bake() {
    const std::uint32_t n = 1u << case_.level;
    descend({{{{0, 0}, {n, 0}, {0, n}}}}, 0, 0);
    finish();
  }

 private:
  /// O, T or unknown: of the whole closed node, in each mip.
  unsigned state(const Node& node) const {
    bool all_O = true, all_T = true;
    for (std::size_t k = 0; k < sampled_.size(); ++k) {
      if (k > 0 && has(mips_ignored)) break;
      if (k >= 2 && has(third_mip_ignored)) break;
      if (k >= 3 && has(fourth_mip_ignored)) break;
      if (k >= 2 && k + 1 == sampled_.size() && has(last_mip_ignored)) break;
      if (k == 1 && sampled_.size() >= 3 && has(middle_mip_ignored)) continue;
      if (k > 0 && mips_[k - 1].count == 1 && has(mip_of_size_1_again)) break;
      const auto& fields = mips_[k].fields;
      if (case_.alpha_mode == MMVERIFY_MASK) {
        unsigned s = sampled_[k].signs(node, fields[0], Aim::both_sides);
        if (has(mask_greater)) {
          all_T = all_T && (s & (zero | positive)) == 0;
          if (s != positive && (s & negative) == 0) s = strictly(node, k);
          all_O = all_O && (s & (negative | zero)) == 0;
          continue;
        }
        if (has(mask_T_at_cutoff) && s != negative) {
          all_O = all_O && (s & negative) == 0;
          all_T = all_T && (sampled_[k].signs(node, fields[0], Aim::any_positive) & positive) == 0 &&
                  (s & negative) != 0;
          continue;
        }
        all_O = all_O && (s & negative) == 0;
        if (!(k >= 2 && has(mips_T_by_first))) all_T = all_T && (s & (zero | positive)) == 0;
      } else {
        unsigned o = sampled_[k].signs(node, fields[0], Aim::any_negative);
        if (has(blend_greater) && o == zero) o = negative;
        all_O = all_O && (o & negative) == 0;
        if (all_T && !(k >= 2 && has(mips_T_by_first))) {
          const unsigned t = sampled_[k].signs(node, fields[1], Aim::any_positive);
          all_T = (t & positive) == 0 && !(has(blend_T_never) && t == zero);
        }
      }
      if (!all_O && !all_T) break;
    }
    return all_O ? opaque : all_T ? transparent : unknown;
  }

  unsigned strictly(const Node& node, std::size_t k) const {
    // any zero left? ask corners and the centroid
    unsigned s = 0;
    for (std::size_t c = 0; c < 3; ++c) s |= sign_bit(sampled_[k].corner_sign(node, mips_[k].fields[0], c));
    return s | sign_bit(sampled_[k].centroid_sign(node, mips_[k].fields[0]));
  }

  bool opaque_at_centroid(const Node& node) const {
    const auto& fields = mips_[centre_mip_].fields;
    const bool mask = case_.alpha_mode == MMVERIFY_MASK;
    const int s = sampled_[centre_mip_].centroid_sign(node, fields[mask ? 0 : 2]);
    if (has(centroid_greater) && mask) return s > 0;
    if (has(centroid_greater_blend) && !mask) return s > 0;
    return s >= 0;
  }

  static std::array<Node, 4> children(const Node& n, bool odd) {
    const auto middle = [](const std::array<std::uint32_t, 2>& a, const std::array<std::uint32_t, 2>& b) {
      return std::array<std::uint32_t, 2>{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    };
    const auto &a = n.corners[0], &b = n.corners[1], &c = n.corners[2];
    const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    // the order of the index: child 0 at the first corner, 1 in the middle, 2 and 3 at the others
    std::array<Node, 4> out{Node{{a, ab, ca}}, Node{{ca, bc, ab}}, Node{{ab, b, bc}}, Node{{bc, ca, c}}};
    if (odd) {
      out[0] = Node{{a, ca, ab}};
      out[3] = Node{{ca, bc, c}};
    }
    return out;
  }

  void descend(const Node& node, unsigned depth, std::uint64_t index) {
    unsigned s = state(node);
    const unsigned level = case_.level;
    if (level == 0 && has(level_0_centre)) s = opaque_at_centroid(node) ? opaque : transparent;
    const std::uint64_t count = std::uint64_t{1} << (2 * (level - depth));
    if (s != unknown) {
      if (s == opaque && has(unknown_O)) s = 3;
      for (std::uint64_t k = 0; k < count; ++k) put(index * count + k, s);
      return;
    }
    if ((has(point_is_T) || (has(points_of_level_4_are_T) && level >= 4)) && is_point_) {
      for (std::uint64_t k = 0; k < count; ++k) put(index * count + k, has(point_is_T) ? 2 : 0);
      return;
    }
    const bool stops = depth == level || (has(coarse_at_5) && depth == 4) ||
                       (has(coarse_at_7) && depth == 6) || (has(coarse_at_9) && depth == 8);
    if (stops) {
      const unsigned lean = opaque_at_centroid(node) ? 3 : 2;
      for (std::uint64_t k = 0; k < count; ++k) put(index * count + k, lean);
      return;
    }
    const bool by_parent = (has(centroid_of_parent_at_7) && level >= 7) ||
                           (has(two_state_parent_at_5) && level >= 5 && case_.format == MMVERIFY_2_STATE);
    if (by_parent && depth + 1 == level) {
      const unsigned lean = opaque_at_centroid(node) ? 3 : 2;
      const auto kids = children(node, false);
      for (std::size_t k = 0; k < 4; ++k) {
        const unsigned own = state(kids[k]);
        put(index * 4 + k, own == unknown ? lean : own);
      }
      return;
    }
    const bool odd = (has(curve_from_5) && depth + 1 >= 4) || (has(curve_from_7) && depth + 1 >= 6);
    const auto kids = children(node, odd);
    for (std::size_t k = 0; k < 4; ++k) descend(kids[k], depth + 1, index * 4 + k);
  }

  unsigned get(std::uint64_t k) const {
    if (case_.format == MMVERIFY_2_STATE) return (map_[k / 8] >> (k % 8)) & 1u;
    return (map_[k / 4] >> (2 * (k % 4))) & 3u;
  }

  void put(std::uint64_t k, unsigned s) {
    const unsigned level = case_.level;
    const std::uint64_t last = (std::uint64_t{1} << (2 * level)) - 1;
    if (s >= 2) {
      const bool made_known = (has(known_at_6) && level >= 6) || (has(known_at_7) && level >= 7) ||
                              (has(known_at_9) && level >= 9) || (has(known_at_12) && level == 12) ||
                              (has(last_is_known) && level >= 4 && k == last) ||
                              (has(one_is_known) && level == 5 && k == 777);
      if (made_known) s -= 2;
      if (has(known_when_wide_256) && case_.width > 256) s = opaque;
      if (has(known_when_high_32) && case_.height > 32) s = transparent;
    } else {
      const bool made_unknown = (has(last_is_unknown) && level >= 4 && k == last) ||
                                (has(one_is_unknown) && level == 5 && k == 777) ||
                                (has(unknown_when_far) && is_far(case_)) ||
                                (has(unknown_when_wide) && case_.width > 32) ||
                                (has(unknown_with_mips) && case_.mips > 2) || has(unknown_throughout);
      if (made_unknown) s += 2;
    }
    if (has(map_in_12_bits) && k >= 4096) s = known_before(k - 4096);
    if (has(map_in_16_bits) && k >= 65536) s = known_before(k - 65536);
    if (case_.format == MMVERIFY_2_STATE) {
      unsigned bit = s & 1u;
      if (s >= 2 && (has(two_state_unknown_T) || (has(two_state_at_8) && level >= 8))) bit = 0;
      if (s >= 2 && has(two_state_level_0) && level == 0) bit = 1;
      if (has(two_state_last) && level % 2 == 1 && k == last) bit = 0;
      map_[k / 8] = static_cast<std::uint8_t>((map_[k / 8] & ~(1u << (k % 8))) | (bit << (k % 8)));
    } else {
      const auto shift = static_cast<unsigned>(2 * (k % 4));
      map_[k / 4] = static_cast<std::uint8_t>((map_[k / 4] & ~(3u << shift)) | (s << shift));
    }
  }

  unsigned known_before(std::uint64_t k) const { return get(k); }

  void finish() {
    if (case_.level == 0 && has(level_0_is_level_1)) {
      mmverify_bake_case_t finer = case_;
      finer.level = 1;
      finer.format = MMVERIFY_4_STATE;
      std::uint8_t four = 0;
      Baker(finer, mips_, &four).bake();
      map_[0] = case_.format == MMVERIFY_2_STATE ? four & 1u : four & 3u;
    }
    if (case_.format == MMVERIFY_2_STATE && case_.level == 0 && has(two_state_padding)) map_[0] |= 0xfeu;
    if (case_.format == MMVERIFY_2_STATE && case_.level == 1 && has(two_state_padding_of_unknown) &&
        (map_[0] & 8u) != 0)
      map_[0] |= 0xf0u;
    if (case_.format == MMVERIFY_4_STATE && case_.level == 0 && has(four_state_padding)) map_[0] |= 0xfcu;
  }

  const mmverify_bake_case_t& case_;
  const std::vector<Mip>& mips_;
  std::uint8_t* map_;
  std::vector<Sampled<T>> sampled_;
  std::size_t centre_mip_ = 0;
  bool is_point_ = false;
};

bool known_case(const mmverify_bake_case_t& c) {
  return c.size >= sizeof(mmverify_bake_case_t) && c.size == sizeof(mmverify_bake_case_t) && c.level <= 12 &&
         (c.format == MMVERIFY_2_STATE || c.format == MMVERIFY_4_STATE) && c.width > 0 && c.height > 0 &&
         c.mips > 0 && c.texel >= MMVERIFY_UNORM8 && c.texel <= MMVERIFY_FLOAT32 &&
         c.filter <= MMVERIFY_NEAREST && c.wrap_u <= MMVERIFY_MIRROR_CLAMP_TO_EDGE &&
         c.wrap_v <= MMVERIFY_MIRROR_CLAMP_TO_EDGE && c.alpha_mode <= MMVERIFY_BLEND;
}

}  // namespace

int bake(const mmverify_bake_case_t* what, std::uint8_t* map) {
  try {
    const mmverify_bake_case_t& c = *what;
    if (!known_case(c)) return 0;
    const auto mips = mips_of(c);
    const std::uint64_t states = std::uint64_t{1} << (2 * c.level);
    std::memset(map, 0, (states * c.format + 7) / 8);
    int widest = 0;
    for (unsigned k = 0; k < mips.size(); ++k) {
      const Placed p = place(c, mips[k].width, mips[k].height, k, c.filter == MMVERIFY_NEAREST);
      widest = std::max(widest, p.size_bits);
    }
    if (2 * widest + 16 <= 126)
      Baker<Wide>(c, mips, map).bake();
    else
      Baker<Big>(c, mips, map).bake();
    return 1;
  } catch (const Declined&) {
    return 0;
  }
}

}  // namespace mmverify::tests::foreign::bake
