#include "proofs/traverse/laws.hpp"

#include "proofs/traverse/law_groups.hpp"

namespace mmverify::proofs::traverse {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group : {decision_laws(), lossy_laws(), blend_laws(), blend_sample_laws(), order_laws(),
                            many_hits_laws(), image_laws(), payload_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::traverse
