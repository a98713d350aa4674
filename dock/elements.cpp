#include "dock/elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "dock/broken.hpp"

namespace mmverify::dock {
namespace {

/// Elements [from, from + count), as many as one command takes.
void ask_piece(const Library& library, const Elements& e, std::size_t from, std::size_t count,
               std::byte* out) {
  const EntryPoint& entry = entry_point(e.call);
  const std::size_t bytes = entry.signature.number_bytes, wide = entry.answer_bytes;
  const auto each_batch = [count](auto visit) {
    for (std::size_t at = 0; at < count; at += batch_size) visit(at, std::min(batch_size, count - at));
  };
  Borrowed worker(library.pool());
  for (std::size_t a = 0; a < e.arrays.size(); ++a)
    each_batch([&](std::size_t at, std::size_t size) {
      std::memcpy(worker->input(e.call, a, count, at),
                  static_cast<const std::byte*>(e.arrays[a]) + (from + at) * bytes, size * bytes);
    });
  try {
    worker->ask(e.call, e.level, count, e.format);
  } catch (const Misbehaved& found) {
    const std::size_t first = from + static_cast<std::size_t>(found.first);
    const std::string one = e.element(first);
    throw SubjectBroken(fmt::format(
        "{} at level {} {}", found.what, e.level,
        found.count == 1 ? "on case " + one
                         : fmt::format("in the batch of {} cases from {} to {}", found.count, one,
                                       e.element(first + static_cast<std::size_t>(found.count) - 1))));
  }
  each_batch([&](std::size_t at, std::size_t size) {
    std::memcpy(out + at * wide, worker->answer(e.call, count, at), size * wide);
  });
  worker.give_back();
}

}  // namespace

void ask(const Library& library, const Elements& e, std::size_t count, void* out) {
  for (std::size_t from = 0; from < count; from += capacity)
    ask_piece(library, e, from, std::min(capacity, count - from),
              static_cast<std::byte*>(out) + from * entry_point(e.call).answer_bytes);
}

}  // namespace mmverify::dock
