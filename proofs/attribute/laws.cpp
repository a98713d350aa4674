#include "proofs/attribute/laws.hpp"

#include "proofs/attribute/induction/provable.hpp"
#include "proofs/attribute/law_groups.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group : {order_laws(), induction::laws(), lookup_laws(), decimation_laws(), mip_laws(),
                            bake_laws(), compression_laws(), paper_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::attribute
