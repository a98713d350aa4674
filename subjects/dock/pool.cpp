#include <algorithm>
#include <thread>
#include <utility>

#include "subjects/dock/worker.hpp"

namespace mmverify::dock {

std::unique_ptr<Worker> Pool::take() {
  {
    const std::lock_guard hold(lock_);
    // The last worker that this thread gave back, or else the last of all.
    const auto own = std::find_if(idle_.rbegin(), idle_.rend(),
                                  [](const Idle& idle) { return idle.by == std::this_thread::get_id(); });
    if (!idle_.empty()) {
      const auto taken = own != idle_.rend() ? own.base() - 1 : idle_.end() - 1;
      auto worker = std::move(taken->worker);
      idle_.erase(taken);
      return worker;
    }
  }
  return fresh();
}

std::unique_ptr<Worker> Pool::fresh() {
  Before before{{}, loaded_, &file_};
  {
    const std::lock_guard hold(lock_);
    before.asked = asked_;
  }
  auto worker = std::make_unique<Worker>(library_, options_, std::move(before));
  loaded_ = true;
  return worker;
}

void Pool::replace(std::unique_ptr<Worker> worker) {
  const std::lock_guard hold(lock_);
  for (const auto& [kind, count] : worker->asked()) asked_[kind] = std::max(asked_[kind], count);
}

void Pool::give_back(std::unique_ptr<Worker> worker) {
  const std::lock_guard hold(lock_);
  idle_.push_back({std::move(worker), std::this_thread::get_id()});
}

}  // namespace mmverify::dock
