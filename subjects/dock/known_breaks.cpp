#include "subjects/dock/known_breaks.hpp"

namespace mmverify::dock {
namespace {

std::string inputs_of(const Worker& worker, Call call, std::uint64_t count, std::uint64_t t) {
  const Signature signature = entry_point(call).signature;
  std::string bytes;
  for (std::size_t array = 0; array < signature.arrays; ++array)
    bytes.append(reinterpret_cast<const char*>(worker.input(call, array, count, t)), signature.number_bytes);
  return bytes;
}

}  // namespace

void KnownBreaks::add(const Worker& worker, const Command& c, std::uint64_t t, const Break& what) {
  const std::lock_guard hold(lock_);
  known_[{c.call, c.level, c.format}].emplace(inputs_of(worker, c.call, c.count, t), what);
}

std::optional<KnownBreaks::BrokenElement> KnownBreaks::first(const Worker& worker, const Command& c) const {
  const std::lock_guard hold(lock_);
  const auto of_level = known_.find({c.call, c.level, c.format});
  if (of_level == known_.end()) return std::nullopt;
  for (std::uint64_t t = 0; t < c.count; ++t)
    if (const auto one = of_level->second.find(inputs_of(worker, c.call, c.count, t));
        one != of_level->second.end())
      return BrokenElement{t, one->second};
  return std::nullopt;
}

}  // namespace mmverify::dock
