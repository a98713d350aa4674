#include "proofs/bake/truth/truth.hpp"
#include "proofs/scene/law_parts.hpp"
#include "proofs/scene/laws.hpp"

namespace mmverify::proofs::scene {
namespace {

std::string number_text(const spec::Rational& q) {
  return fmt::format("{:.9g}", boost::rational_cast<double>(q));
}

/// "micro-triangle 12, where alpha is 0.25 to 0.75 and the cutoff 0.5": the first of those that are wrong.
std::string wrong_place(const SubjectMaps& maps, std::size_t triangle, std::uint32_t index,
                        std::size_t count) {
  const bake::Case one = maps.case_of(triangle);
  const Level n = maps.data().baked.triangles[triangle].level;
  const bake::Extremes alpha = bake::extremes(one, n, index);
  std::string text = fmt::format("micro-triangle {}, where alpha is {} to {}", index,
                                 number_text(alpha.least.alpha), number_text(alpha.greatest.alpha));
  if (!one.blend)
    text += fmt::format(" and the cutoff {:.9g}",
                        static_cast<double>(one.cutoff.numerator) / one.cutoff.denominator);
  const auto& uv = maps.data().plan.triangles[triangle].uvs;
  text += fmt::format(", UVs ({:a}, {:a}), ({:a}, {:a}), ({:a}, {:a})", uv[0][0], uv[0][1], uv[1][0],
                      uv[1][1], uv[2][0], uv[2][1]);
  if (count > 1) text += fmt::format("; {} of this triangle", count);
  return text;
}

struct MapLaw {
  const char *id, *says, *expected, *got;
  std::vector<std::uint32_t> WrongStates::*wrong;
};

constexpr MapLaw two_laws[] = {{"bake.conservative", "a micro-triangle is T or O only where all of it is",
                                "no O or T that is not", "one", &WrongStates::known},
                               {"bake.tight", "a micro-triangle is unknown only where it is truly mixed",
                                "no unknown that is all O or all T", "one", &WrongStates::unknown}};

Law law_of_maps(const MapLaw& map_law, const SubjectMaps& maps) {
  Law law;
  law.id = map_law.id;
  law.topic = "bake";
  law.says = map_law.says;
  law.source = "VK_KHR_opacity_micromap, opacity states; glTF 2.0, Alpha Coverage";
  std::vector<std::vector<std::size_t>> of_level(13);
  for (std::size_t k = 0; k < maps.data().baked.triangles.size(); ++k)
    if (maps.asks(k)) of_level.at(maps.data().baked.triangles[k].level).push_back(k);
  Domain parts{"distinct triangles that it declares",
               [of_level](Level n) { return n < of_level.size() ? of_level[n].size() : 0; },
               [&maps, &map_law, of_level](Level n, std::uint64_t number) -> Finding {
                 const std::size_t triangle = of_level[n][number];
                 const WrongStates* const states = maps.wrong(triangle);
                 if (states == nullptr) return {.declined = true};
                 const auto& wrong = states->*map_law.wrong;
                 if (wrong.empty()) return {};
                 Finding finding{.holds = false};
                 finding.in_words = [&maps, &map_law, triangle, index = wrong.front(), count = wrong.size()] {
                   return Words{map_law.expected, fmt::format("{}: {}", map_law.got,
                                                              wrong_place(maps, triangle, index, count))};
                 };
                 return finding;
               }};
  law = on_cases(std::move(law), std::move(parts));
  // Ours are proved on families and checked on scenes, not proved on this one.
  law.method = Method::sample;
  law.how = "each map beside this project's; where its rules are others, beside the specification";
  return law;
}

}  // namespace

SubjectLaws subject_laws(const SubjectMaps& maps, const std::string& command) {
  SubjectLaws all;
  for (const MapLaw& map_law : two_laws) all.laws.push_back(law_of_maps(map_law, maps));
  // A subject that the laws name: not owned by them.
  const SubjectPtr subject(&maps.subject(), [](const Subject*) {});
  for (Law& law : all.laws) {
    law.replayed_by = fmt::format("{} --replay {}", command, law.id);
    for (Level n = 0; n <= 12; ++n)
      if (!law.unfit(*subject, n)) all.jobs.push_back({&law, subject, {n, n}, {}});
  }
  return all;
}

}  // namespace mmverify::proofs::scene
