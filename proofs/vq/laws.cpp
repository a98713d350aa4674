#include "proofs/vq/laws.hpp"

namespace mmverify::proofs::vq {

std::vector<Law> laws() {
  std::vector<Law> all{vectors_law(), transforms_law(), codes_law()};
  for (const auto& group : {field_laws(), decoder_laws(), encoder_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::vq
