#include "subjects/dock/desk/fenced.hpp"

namespace mmverify::dock {

Fenced::Fenced(std::size_t bytes, unsigned char filling, std::size_t behind, std::size_t least)
    : bytes_(bytes), filling_(filling), room_(bytes + 2 * (least + line), std::byte{canary}) {
  at_ = before_line(room_) + least + behind;
  std::fill_n(data(), bytes, std::byte{filling});
}

}  // namespace mmverify::dock
