// Loops in place of oneTBB's: a program of WebAssembly has one thread.  More threads are more programs, each
// with its shard.
#pragma once

#include <oneapi/tbb/blocked_range.h>

namespace oneapi::tbb {

struct simple_partitioner {};

/// Calls body(k) for each k of [first, last).
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
  for (Index k = first; k < last; ++k) body(k);
}

/// Calls body(range) with the whole range at once.
template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body, simple_partitioner = {}) {
  body(range);
}

}  // namespace oneapi::tbb
