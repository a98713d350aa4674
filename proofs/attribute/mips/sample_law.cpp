// Mips of whole random pictures: what codes in a fixed order leave out, a byte that is read in another one's place.
#include "proofs/attribute/mips/law_parts.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

constexpr std::uint64_t fast_face_pictures = 4'000, long_face_pictures = 400'000, most_parents = 70;
constexpr std::uint64_t picture_stream = 0x6d697073;

/// FacePicture `number` of a seed: up to 70 parents' children.
struct FacePicture {
  Rounding rounding;
  std::uint64_t seed, number;
};

std::vector<std::uint32_t> children_of(const FacePicture& p) {
  Random random(p.seed, picture_stream, p.number);
  std::vector<std::uint32_t> children(4 * (1 + random.below(most_parents)));
  for (std::uint32_t& word : children) word = random.four_codes();
  return children;
}

Finding are_means(const AttributeSubject& s, const FacePicture& p) {
  const std::vector<std::uint32_t> children = children_of(p);
  std::vector<std::uint32_t> parents(children.size() / 4);
  s.functions.mips.face_mip(p.rounding, children, parents);
  Finding found;
  for (std::size_t k = 0; k < parents.size(); ++k) {
    found.answer += Tally::digest_of(k, parents[k]);
    for (unsigned which = 0; which < 4; ++which) {
      Codes x;
      for (std::size_t c = 0; c < 4; ++c) x[c] = children[4 * k + c] >> 8 * which & 255;
      const std::uint32_t got = parents[k] >> 8 * which & 255;
      if (is_rounded(p.rounding, x, got)) continue;
      return wrong(fmt::format("face {}, {}: the mean of {}, {}", k, "RGBA"[which], fmt::join(x, " "),
                               rounding_name(p.rounding)),
                   fmt::format("{}", got));
    }
  }
  return found;
}

/// Reads other children than it is given.
std::function<void(Functions&)> reading_other_children(void (*change)(std::vector<std::uint32_t>&)) {
  return [change](Functions& f) {
    f.mips.face_mip = [change, real = f.mips.face_mip](Rounding r, std::span<const std::uint32_t> children,
                                                       std::span<std::uint32_t> parents) {
      std::vector<std::uint32_t> others(children.begin(), children.end());
      change(others);
      real(r, others, parents);
    };
  };
}

}  // namespace

Law mip_sample_law() {
  Cases<FacePicture> cases;
  cases.count = {fast_face_pictures, long_face_pictures};
  cases.number = [](Level, std::uint64_t k, std::uint64_t seed) {
    return FacePicture{static_cast<Rounding>(k % 4), seed, k};
  };
  cases.text = [](Level, const FacePicture& p) {
    return fmt::format("{},seed={},picture={}", rounding_name(p.rounding), p.seed, p.number);
  };
  cases.read = [](Level, const std::string& at) {
    const Groups g = groups_of(at, "([a-z-]+),seed=(\\d+),picture=(\\d+)");
    if (!g) throw BadCase(fmt::format("'{:.60}': write half-up,seed=1,picture=2", at));
    return FacePicture{rounding_of((*g)[1], at), number_of((*g)[2], at, ~std::uint64_t{0} >> 8),
                       number_of((*g)[3], at, long_face_pictures)};
  };
  cases.check = [](const AttributeSubject& s, Level, const FacePicture& p) { return are_means(s, p); };
  return on_cases(
      {.id = "attribute.mip_on_samples",
       .says = "each code of each face of a mip is the mean of its four children's same code, whatever the "
               "others are",
       .source = "Color and Attribute Micromaps, 4.4, which names no rounding; docs/ATTRIBUTE.md",
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.seconds = 0.2},
       .at_once = "all levels",
       .domain = "4 roundings; pictures of 1 to 70 parents, each byte of each child drawn on its own, half "
                 "of them 0, 1, 127, 128, 254 or 255",
       .mutants = {mutant("A of child 3 is child 0's in the last face of odd pictures", "attribute-spec",
                          {0, 0}, reading_other_children([](std::vector<std::uint32_t>& children) {
                            if (children.size() % 8 == 0) return;
                            std::uint32_t& last = children.back();
                            last = (last & 0xFFFFFF) | (children[children.size() - 4] & 0xFF000000);
                          }))}},
      needing({face_mip_entry}), std::move(cases));
}

}  // namespace mmverify::proofs::attribute
