#include "subjects/source/executor/obligations.hpp"

namespace mmverify::source::executor {
namespace {

using circuit::Answer;

/// Conflicts for an obligation when it comes up.
constexpr int first_effort = 2000;

}  // namespace

void Obligations::require_never(Duty duty, Literal condition, Literal broken, const llvm::Instruction& at,
                                const std::string& what) {
  ++made_;
  if (condition == never || broken == never || duty == dropped_) return;
  switch (sweeper_.both_possible(condition, broken, first_effort)) {
    case Answer::impossible: return;
    case Answer::possible: throw Refuted(place_of(at) + ": " + what, sweeper_.example());
    case Answer::unknown: open_.push_back({condition, broken, place_of(at) + ": " + what});
  }
}

void Obligations::settle() {
  while (!open_.empty()) {
    const Open& one = open_.back();
    const Answer got = sweeper_.both_possible(one.condition, one.broken, circuit::all_conflicts);
    if (got == Answer::possible) throw Refuted(one.what, sweeper_.example());
    if (got == Answer::unknown) throw Undecided(one.what + "?");
    sweeper_.claim_never(one.condition, one.broken);
    open_.pop_back();
  }
  const Answer some = sweeper_.assumptions_possible();
  if (some == Answer::unknown) throw Undecided("whether any input keeps the law's assumptions");
  if (some == Answer::impossible) throw Vacuous("the law's assumptions leave no input, so it says nothing");
}

}  // namespace mmverify::source::executor
