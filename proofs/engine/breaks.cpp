#include "proofs/engine/breaks.hpp"

#include <algorithm>

namespace mmverify::proofs {

void Breaks::note(Level level, std::uint64_t k, const dock::CaseBroken& what) {
  const std::lock_guard hold(lock_);
  found_.emplace(std::pair(level, k), what.what());
  hung_ += what.hung ? 1 : 0;
  const bool of_everything = !answered_ && (found_.size() >= most_unanswered || what.hung);
  if (of_everything || found_.size() >= most_ || hung_ >= most_hung)
    throw dock::SubjectBroken(found_.lower_bound({level, 0})->second);
}

std::vector<std::string> Breaks::at(Level level) const {
  const std::lock_guard hold(lock_);
  std::vector<std::string> all;
  for (auto one = found_.lower_bound({level, 0}); one != found_.end() && one->first.first == level; ++one)
    if (std::find(all.begin(), all.end(), one->second) == all.end()) all.push_back(one->second);
  return all;
}

}  // namespace mmverify::proofs
