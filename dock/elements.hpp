// Questions about many elements at once: points, indices, places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dock/library.hpp"

namespace mmverify::dock {

struct ElementsQuestion {
  Call call;
  std::uint32_t level;
  std::uint64_t count;                 ///< up to capacity
  std::function<void(Worker&)> place;  ///< writes the inputs to where Worker::input says
  std::function<std::string(const Worker&, std::uint64_t t)>
      text;  ///< names element t, whose inputs are in place
  std::uint32_t format = 0;
};

/// Asks any worker of the library, and returns it with the answers, to be given back.  An element on which the
/// library crashes, throws or hangs, asked by itself as well, is a CaseBroken, then and whenever it is among those
/// asked: it is not asked again.  What else the library does instead of answering is a SubjectBroken.
Borrowed ask(const Library& library, const ElementsQuestion& question);

/// Elements that have a number in each array of the entry point, any number of them.
struct Elements {
  Call call;
  std::uint32_t level, format;
  std::vector<const void*> arrays;
  std::function<std::string(std::size_t)> element;  ///< names one, for messages
};

/// Writes the answers, one after the other, to `out`, which has room for `count` of them.
/// Domain: numbers of the entry point's width.  Throws as the one above does.
void ask_all(const Library& library, const Elements& elements, std::size_t count, void* out);

}  // namespace mmverify::dock
