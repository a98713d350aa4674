#include "proofs/micromap/laws.hpp"

#include "proofs/micromap/law_groups.hpp"

namespace mmverify::proofs::micromap {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group :
       {map_laws(), apart_laws(), count_laws(), lossy_laws(), special_laws(), array_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::micromap
