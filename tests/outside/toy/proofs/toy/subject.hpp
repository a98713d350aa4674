// A subject of topic toy.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "proofs/engine/topic.hpp"

namespace mmverify::proofs::toy {

struct Functions {
  static constexpr char topic[] = "toy";
  std::function<std::uint32_t(std::uint32_t)> twice = {};
  bool exact_answers() const { return true; }
};

using ToySubject = SubjectOf<Functions>;
using ToySubjectPtr = std::shared_ptr<const ToySubject>;

/// The library.
const std::vector<ToySubjectPtr>& built_in_subjects();

}  // namespace mmverify::proofs::toy
