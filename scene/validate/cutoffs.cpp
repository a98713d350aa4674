#include "scene/validate/cutoffs.hpp"

#include <string>

#include "scene/read/document.hpp"

namespace mmverify::scene {

std::vector<FileViolation> cutoffs_above_1(const Document& document) {
  std::vector<FileViolation> findings;
  const nlohmann::json& materials = member(document.json, "materials");
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const nlohmann::json& cutoff = member(materials[m], "alphaCutoff");
    const nlohmann::json& mode = member(materials[m], "alphaMode");
    if (mode != "MASK" || !cutoff.is_number() || !(cutoff.get<double>() > 1)) continue;
    findings.push_back({"material.cutoff", "/materials/" + std::to_string(m) + "/alphaCutoff",
                        cutoff.dump() + " is above 1: every texel is transparent"});
  }
  return findings;
}

}  // namespace mmverify::scene
