// Ways that a run ends before its end.
#pragma once

#include <llvm/IR/Instruction.h>

#include <stdexcept>
#include <string>

#include "subjects/source/circuit/sweeper.hpp"

namespace mmverify::source::executor {

/// FILE:LINE of the instruction; its function's name where the bitcode has no line.
std::string place_of(const llvm::Instruction& at);

/// The program does something that cannot be followed; what() begins with file and line.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
  Unreadable(const llvm::Instruction& at, const std::string& why)
      : std::runtime_error(place_of(at) + ": " + why) {}
};

/// The budget is spent.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// No input keeps the law's assumptions.
struct Vacuous : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An obligation is broken; what() begins with file and line.
struct Refuted : std::runtime_error {
  Refuted(const std::string& what, circuit::Inputs inputs)
      : std::runtime_error(what), inputs(std::move(inputs)) {}
  circuit::Inputs inputs;
};

}  // namespace mmverify::source::executor
