#include "dock/elements.hpp"

#include <fmt/format.h>

#include "dock/broken.hpp"

namespace mmverify::dock {
namespace {

std::string what_broke(const Worker& worker, const ElementsQuestion& q, const Misbehaved& found) {
  const std::string first = q.text(worker, found.first);
  if (found.count == 1) return fmt::format("{} at level {} on case {}", found.what, q.level, first);
  return fmt::format("{} at level {} in the batch of {} cases from {} to {}", found.what, q.level,
                     found.count, first, q.text(worker, found.first + found.count - 1));
}

}  // namespace

Borrowed ask(const Library& library, const ElementsQuestion& q) {
  Borrowed worker(library.pool());
  q.place(*worker);
  KnownBreaks& breaks = library.known_breaks();
  if (const auto known = breaks.first(*worker, q.call, q.level, q.count)) {
    const CaseBroken again(what_broke(*worker, q, {known->known.what, known->element, 1}), known->known.hung);
    worker.give_back();
    throw again;
  }
  try {
    worker->ask(q.call, q.level, q.count);
  } catch (const Misbehaved& found) {
    // The search for the element has left other inputs.
    q.place(*worker);
    const std::string what = what_broke(*worker, q, found);
    if (!found.alone) throw SubjectBroken(what);
    breaks.add(*worker, q.call, q.level, q.count, found.first, {found.what, found.hung});
    throw CaseBroken(what, found.hung);
  }
  return worker;
}

}  // namespace mmverify::dock
