// A compiled function's library in this process, and numbers to ask it with.
#pragma once

#include <dlfcn.h>

#include <bit>
#include <cstdint>
#include <stdexcept>

#include "proofs/engine/random.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "subjects/source/compile.hpp"

namespace mmverify::tests {

class Opened {
 public:
  explicit Opened(const source::Compiled& made) : handle_(dlopen(made.library().c_str(), RTLD_NOW)) {
    if (handle_ == nullptr) throw std::runtime_error(dlerror());
    subject_ = reinterpret_cast<const mmverify_subject_t* (*)()>(dlsym(handle_, "mmverify_subject_v1"))();
  }
  ~Opened() { dlclose(handle_); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  std::uint32_t operator()(std::uint32_t level, float u, float v) const {
    std::uint32_t index = 0;
    subject_->index_f32(level, &u, &v, &index, 1);
    return index;
  }

 private:
  void* handle_;
  const mmverify_subject_t* subject_ = nullptr;
};

/// Any bits up to those of 1; on a line of level 10; just below 1; subnormal; 0 or -0; any multiple of 2^-24.
inline float some_float(proofs::Random& random) {
  switch (random.below(6)) {
    case 0: return std::bit_cast<float>(static_cast<std::uint32_t>(random.below(0x3f800001)));
    case 1: return static_cast<float>(random.below(1025)) / 1024;
    case 2: return std::bit_cast<float>(static_cast<std::uint32_t>(0x3f800000 - random.below(4)));
    case 3: return std::bit_cast<float>(static_cast<std::uint32_t>(random.below(1 << 24)));
    case 4: return random.below(2) == 0 ? 0.0f : -0.0f;
    default: return static_cast<float>(random.below(1 << 24)) / (1 << 24);
  }
}

}  // namespace mmverify::tests
