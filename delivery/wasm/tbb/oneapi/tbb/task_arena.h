// The arena of the only thread.
#pragma once

#include <utility>

namespace oneapi::tbb {

class task_arena {
 public:
  static constexpr int automatic = -1;
  explicit task_arena(int = automatic) {}

  /// Calls body() in this thread.
  template <class Body>
  auto execute(Body&& body) {
    return std::forward<Body>(body)();
  }
};

namespace this_task_arena {

template <class Body>
auto isolate(Body&& body) {
  return std::forward<Body>(body)();
}

}  // namespace this_task_arena
}  // namespace oneapi::tbb
