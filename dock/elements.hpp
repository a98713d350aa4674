// Questions about many elements at once: points, indices.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "dock/library.hpp"

namespace mmverify::dock {

struct ElementsQuestion {
  Call call;
  std::uint32_t level;
  std::uint64_t count;                 ///< up to capacity
  std::function<void(Worker&)> place;  ///< writes the inputs to where Worker::input says
  std::function<std::string(const Worker&, std::uint64_t t)>
      text;  ///< names element t, whose inputs are in place
};

/// Asks any worker of the library, and returns it with the answers, to be given back.  An element on which the
/// library crashes, throws or hangs, asked by itself as well, is a CaseBroken, then and whenever it is among those
/// asked: it is not asked again.  What else the library does instead of answering is a SubjectBroken.
Borrowed ask(const Library& library, const ElementsQuestion& question);

}  // namespace mmverify::dock
