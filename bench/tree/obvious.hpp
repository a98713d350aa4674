// The tree as one would first write it: recursion over a flat map, a state and a bit at a time.
#pragma once

#include <cstdint>
#include <span>

#include "impl/tree/stream.hpp"

namespace mmverify::bench {

/// impl::tree::encode_stream's answer.  A node is a leaf if its states, looked at one after the other up to
/// the first that differs, are one; else its children are encoded in turn.
impl::tree::Stream obvious_encode(impl::tree::Level n, impl::tree::Format b,
                                  std::span<const std::uint8_t> map);

/// impl::tree::decode_stream's map, of a stream that is known to be good.  The states of a leaf are written
/// one by one.
void obvious_decode(impl::tree::Level n, impl::tree::Format b, const impl::tree::Stream& s,
                    std::span<std::uint8_t> map);

}  // namespace mmverify::bench
