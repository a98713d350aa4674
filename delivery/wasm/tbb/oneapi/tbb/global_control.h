// A limit of threads, which one thread always keeps.
#pragma once

#include <cstddef>

namespace oneapi::tbb {

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
};

}  // namespace oneapi::tbb
