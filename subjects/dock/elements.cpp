#include "subjects/dock/elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "subjects/dock/broken.hpp"

namespace mmverify::dock {
namespace {

std::string what_broke(const Worker& worker, const ElementsQuestion& q, const Misbehaved& found) {
  const std::string first = q.text(worker, found.first);
  if (found.count == 1) return fmt::format("{} at level {} on case {}", found.what, q.level, first);
  return fmt::format("{} at level {} in the batch of {} cases from {} to {}", found.what, q.level,
                     found.count, first, q.text(worker, found.first + found.count - 1));
}

/// Asks elements [from, from + count), at most one command's.
void ask_piece(const Library& library, const Elements& e, std::size_t from, std::size_t count,
               std::byte* out) {
  const EntryPoint& entry = entry_point(e.call);
  const std::size_t bytes = entry.signature.number_bytes, wide = entry.answer_bytes;
  const auto each_batch = [count](auto visit) {
    for (std::size_t at = 0; at < count; at += batch_size) visit(at, std::min(batch_size, count - at));
  };
  const auto place = [&](Worker& worker) {
    for (std::size_t a = 0; a < e.arrays.size(); ++a)
      each_batch([&](std::size_t at, std::size_t size) {
        std::memcpy(worker.input(e.call, a, count, at),
                    static_cast<const std::byte*>(e.arrays[a]) + (from + at) * bytes, size * bytes);
      });
  };
  const auto text = [&](const Worker&, std::uint64_t t) {
    return e.element(from + static_cast<std::size_t>(t));
  };
  Borrowed worker = ask(library, {e.call, e.level, count, place, text, e.format});
  each_batch([&](std::size_t at, std::size_t size) {
    std::memcpy(out + at * wide, worker->answer(e.call, count, at), size * wide);
  });
  worker.give_back();
}

}  // namespace

Borrowed ask(const Library& library, const ElementsQuestion& q) {
  Borrowed worker(library.pool());
  q.place(*worker);
  const Command command{q.call, q.level, q.format, q.count};
  KnownBreaks& breaks = library.known_breaks();
  if (const auto known = breaks.first(*worker, command)) {
    const CaseBroken again(what_broke(*worker, q, {known->known.what, known->element, 1}), known->known.hung);
    worker.give_back();
    throw again;
  }
  try {
    worker->ask(q.call, q.level, q.count, q.format);
  } catch (const Misbehaved& found) {
    // The search for the element has overwritten the inputs.
    q.place(*worker);
    const std::string what = what_broke(*worker, q, found);
    if (!found.alone) throw SubjectBroken(what);
    breaks.add(*worker, command, found.first, {found.what, found.hung});
    throw CaseBroken(what, found.hung);
  }
  return worker;
}

void ask_all(const Library& library, const Elements& e, std::size_t count, void* out) {
  for (std::size_t from = 0; from < count; from += capacity)
    ask_piece(library, e, from, std::min(capacity, count - from),
              static_cast<std::byte*>(out) + from * entry_point(e.call).answer_bytes);
}

}  // namespace mmverify::dock
