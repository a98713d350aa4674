#include "subjects/dock/desk/questions.hpp"

#include <numeric>

namespace mmverify::dock {

Order over_and_over(std::size_t size, std::size_t count) {
  Order order(size);
  for (std::size_t k = 0; k < size; ++k) order[k] = (k + k / count) % count;
  return order;
}

Order far_apart(std::size_t count) {
  std::size_t stride = count * 618 / 1000 + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  Order order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = k * stride % count;
  return order;
}

Order turned_by_half(std::size_t count) {
  Order order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = (k + count / 2) % count;
  return order;
}

}  // namespace mmverify::dock
