#include "impl/traverse/decision.hpp"

#include <cstddef>
#include <stdexcept>

namespace mmverify::impl::traverse {

void decide(std::span<const std::uint32_t> candidate, std::span<const std::uint32_t> instance,
            std::span<const std::uint32_t> ray, std::span<Outcome> out) {
  if (candidate.size() != out.size() || instance.size() != out.size() || ray.size() != out.size())
    throw std::invalid_argument("decide: spans of different sizes");
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = decide(candidate[k], instance[k], ray[k]);
}

}  // namespace mmverify::impl::traverse
