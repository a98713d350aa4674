// The paper's claims: the true ones as they stand, of the false ones that they are false, and where.
#include "proofs/attribute/law_groups.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> paper_laws() {
  std::vector<Law> all;
  for (const auto& group :
       {order_paper_laws(), lookup_paper_laws(), decimation_paper_laws(), mip_paper_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::attribute
