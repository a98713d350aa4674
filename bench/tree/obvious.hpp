// The tree as a first version would have it: recursion over a flat map, a state and a bit at a time.
#pragma once

#include <cstdint>
#include <span>

#include "impl/tree/stream.hpp"

namespace mmverify::bench {

/// The stream of impl::tree::encode_stream.  A node is a leaf if its states, compared one after the other up
/// to the first that differs, are equal; else its children are encoded in turn.
impl::tree::Stream obvious_encode(impl::tree::Level n, impl::tree::Format b,
                                  std::span<const std::uint8_t> map);

/// The map of impl::tree::decode_stream, for a stream that is known to be good.  The states of a leaf are
/// written one by one.
void obvious_decode(impl::tree::Level n, impl::tree::Format b, const impl::tree::Stream& s,
                    std::span<std::uint8_t> map);

}  // namespace mmverify::bench
