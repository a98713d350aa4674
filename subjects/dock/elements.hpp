// Questions about many elements at once: points, indices, places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "subjects/dock/library.hpp"

namespace mmverify::dock {

struct ElementsQuestion {
  Call call;
  std::uint32_t level;
  std::uint64_t count;                 ///< up to capacity
  std::function<void(Worker&)> place;  ///< writes the inputs at Worker::input
  std::function<std::string(const Worker&, std::uint64_t t)>
      text;  ///< names element t, whose inputs are in place
  std::uint32_t format = 0;
};

/// Asks a worker of the library, and returns it with the answers; the caller gives it back. If the library
/// crashes, throws or hangs on an element that is asked alone, too, a CaseBroken names it; a later question
/// with that element throws again without a call. Any other misbehaviour is a SubjectBroken.
Borrowed ask(const Library& library, const ElementsQuestion& question);

/// Any number of elements; each has a number in each array of the entry point.
struct Elements {
  Call call;
  std::uint32_t level, format;
  std::vector<const void*> arrays;
  std::function<std::string(std::size_t)> element;  ///< names an element, for messages
};

/// Writes the answers to `out`, which has room for `count` of them.
/// Domain: numbers of the entry point's width. Throws as ask() above.
void ask_all(const Library& library, const Elements& elements, std::size_t count, void* out);

}  // namespace mmverify::dock
