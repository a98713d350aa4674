// Asking a library about elements, whole batches at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dock/library.hpp"

namespace mmverify::dock {

/// A question about elements that have a number in each array of the entry point.
struct Elements {
  Call call;
  std::uint32_t level, format;
  std::vector<const void*> arrays;
  std::function<std::string(std::size_t)> element;  ///< names one, for messages
};

/// Writes the answers, one after the other, to `out`, which has room for `count` of them.
/// Domain: numbers of the entry point's width.  Throws SubjectBroken, which names the element that it is about, or the batch
/// where none does it alone.
void ask(const Library& library, const Elements& elements, std::size_t count, void* out);

}  // namespace mmverify::dock
