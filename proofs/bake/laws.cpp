#include "proofs/bake/laws.hpp"

#include "proofs/bake/law_groups.hpp"

namespace mmverify::proofs::bake {

std::vector<Law> laws() {
  std::vector<Law> all = state_laws();
  all.push_back(large_law());
  const std::vector<Law> relations = relation_laws();
  all.insert(all.end(), relations.begin(), relations.end());
  return all;
}

}  // namespace mmverify::proofs::bake
