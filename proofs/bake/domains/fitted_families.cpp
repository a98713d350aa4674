#include "proofs/bake/domains/family.hpp"

namespace mmverify::proofs::bake {
namespace {

/// Turn 0 is the triangle; of 24 the others differ in the order of the vertices, in u and v, and in the sense of u and
/// of v.  What has no bounds is turned over about 0.
Triangle turned(const Triangle& t, std::size_t turn, const Support& support) {
  constexpr std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  const float about = support.bounded() ? support.uv_min + support.uv_max : 0;
  const bool exchange = turn / 6 % 2 != 0, left = turn / 12 % 2 != 0, up = turn / 6 % 4 == 3;
  Triangle other{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = orders[turn % 6][k];
    float u = t[2 * from], v = t[2 * from + 1];
    if (exchange) std::swap(u, v);
    other[2 * k] = left ? about - u : u;
    other[2 * k + 1] = up ? about - v : v;
  }
  return other;
}

Family fitted_family(const Family& family, const Support& support) {
  Family fit = family;
  for (const Texel texel : {Texel::float32, Texel::unorm16, Texel::unorm8})
    if (support.texels.has(texel)) fit.texel = texel;
  fit.spots.clear();
  fit.triangles.clear();
  std::vector<std::pair<Wrap, Wrap>> pairs;
  for (const auto& [u, v] : family.wraps)
    if (support.wraps.has(u) && support.wraps.has(v) && (!support.same_wraps || u == v))
      pairs.emplace_back(u, v);
  Case one;
  one.cutoff = family.cutoff;
  one.filter = family.filter;
  one.blend = family.blend;
  one.width = static_cast<std::uint32_t>(family.alphabet.size());
  one.alpha.assign(family.alphabet.begin(), family.alphabet.end());
  Support of_rules = support;  // the texture stays as it is
  of_rules.max_side = 16384;
  of_rules.powers_of_two = false;
  of_rules.texels = Set();
  const Case ruled = fitted(of_rules, one, 0);
  fit.rules = ruled.rules;
  fit.cutoff = ruled.cutoff;
  fit.filter = ruled.filter;
  if (support.powers_of_two && (family.side & (family.side - 1)) != 0) {
    fit.block = family.side;
    fit.side = 4;
  }
  for (const Triangle& triangle : family.triangles) {
    const std::size_t turns = (family.wraps.size() + pairs.size() - 1) / pairs.size();
    for (std::size_t turn = 0; turn < turns; ++turn) {
      one.uv = triangle;
      one.uv = fitted(of_rules, one, turn).uv;
      fit.triangles.push_back(turned(one.uv, turn, support));
      for (std::size_t pair = 0; pair < pairs.size(); ++pair)
        if (turn * pairs.size() + pair < family.wraps.size())
          fit.spots.push_back({pairs[pair].first, pairs[pair].second, fit.triangles.size() - 1});
    }
  }
  fit.wraps = std::move(pairs);
  return fit;
}

}  // namespace

const Families& fitted(const Families& families, const Support& support) {
  if (support.whole()) return families;
  static std::mutex lock;
  static std::map<std::pair<const Families*, std::string>, std::unique_ptr<const Families>> known;
  const std::lock_guard hold(lock);
  auto& found = known[{&families, support.text()}];
  if (!found) {
    std::vector<Family> all;
    for (const Enumerated& one : families.all()) all.push_back(fitted_family(one.family(), support));
    found = std::make_unique<const Families>(std::move(all));
  }
  return *found;
}

}  // namespace mmverify::proofs::bake
