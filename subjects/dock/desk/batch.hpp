// The numbers of one slot, which the subject has answered.
#pragma once

#include <cstddef>
#include <string>

#include "subjects/dock/desk/caller.hpp"
#include "subjects/dock/desk/worker_memory.hpp"

namespace mmverify::dock {

class Batch {
 public:
  /// At most `one_by_one` elements are worth a call each.
  Batch(const Caller& caller, WorkerMemory& kept, std::size_t slot, std::size_t one_by_one = batch_size)
      : caller(caller), kept(kept), slot(slot), one_by_one(one_by_one) {}

  std::size_t count() const { return in_slot(caller.mailbox().count, slot); }
  /// The first element's number in the command.
  std::size_t first() const { return slot * batch_size; }
  const Signature& signature() const { return caller.entry().signature; }
  std::size_t answer_bytes() const { return caller.entry().answer_bytes; }
  std::byte* answers() const {
    return caller.base() + caller.layout().answer_at(slot, count(), answer_bytes());
  }
  const std::byte* answer(std::size_t k) const { return answers() + k * answer_bytes(); }

  /// The arguments for `count` elements from `at` on.
  Arguments piece(std::size_t at, std::size_t count, std::byte* out = nullptr) const;
  /// The question of the first `count` elements.
  Question question(std::size_t count) const;
  Question whole() const { return question(count()); }

  /// Repeats element order[k] at place k, and compares.
  QuestionCopy ask(const Order& order, const std::string& how) const;
  /// The same with the answers at a guard page, which stops a store of a whole vector over the tail.
  void ask_at_page(const Order& order, const std::string& how) const;
  /// Repeats element k, alone.
  void ask_element(std::size_t k, const std::string& how) const;

  const Caller& caller;
  WorkerMemory& kept;
  const std::size_t slot, one_by_one;
};

}  // namespace mmverify::dock
