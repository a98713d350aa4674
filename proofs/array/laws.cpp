#include "proofs/array/laws.hpp"

#include "proofs/array/law_groups.hpp"

namespace mmverify::proofs::array {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group :
       {build_laws(), order_laws(), merge_laws(), index_laws(), change_laws(), file_laws(), device_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::array
