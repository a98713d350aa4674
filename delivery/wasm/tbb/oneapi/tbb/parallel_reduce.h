// A reduction in one thread, as in parallel_for.h.
#pragma once

#include <oneapi/tbb/blocked_range.h>

#include <utility>

namespace oneapi::tbb {

/// Returns body(range, identity); there are no parts to join.
template <class Range, class Value, class Body, class Join>
Value parallel_reduce(const Range& range, Value identity, const Body& body, const Join&) {
  return body(range, std::move(identity));
}

}  // namespace oneapi::tbb
