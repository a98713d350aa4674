// Obligations: each must hold on every input, and is settled when it comes up or at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "subjects/source/circuit/sweeper.hpp"
#include "subjects/source/executor/planted.hpp"
#include "subjects/source/executor/reasons.hpp"
#include "subjects/source/executor/value.hpp"

namespace mmverify::source::executor {

class Obligations {
 public:
  explicit Obligations(circuit::Sweeper& sweeper) : sweeper_(sweeper) {}

  /// Obligations of that kind are dropped, for a test.
  void drop(Duty duty) { dropped_ = duty; }

  /// No input reaches `at` under `condition` with `broken`. Throws Refuted.
  void require_never(Duty duty, Literal condition, Literal broken, const llvm::Instruction& at,
                     const std::string& what);
  /// Settles the open ones. Throws Refuted, Undecided; Vacuous if the law's assumptions leave no input.
  void settle();

  std::uint64_t made() const { return made_; }
  std::size_t open() const { return open_.size(); }

 private:
  struct Open {
    Literal condition, broken;
    std::string what;
  };
  circuit::Sweeper& sweeper_;
  std::optional<Duty> dropped_;
  std::vector<Open> open_;
  std::uint64_t made_ = 0;
};

}  // namespace mmverify::source::executor
