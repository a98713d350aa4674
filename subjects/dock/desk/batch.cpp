#include "subjects/dock/desk/batch.hpp"

namespace mmverify::dock {

Arguments Batch::piece(std::size_t at, std::size_t count, std::byte* out) const {
  const std::size_t bytes = signature().number_bytes;
  Arguments a{};
  a.level = caller.mailbox().level;
  a.format = caller.mailbox().format;
  for (std::size_t array = 0; array < signature().arrays; ++array)
    a.arrays[array] =
        caller.base() + caller.layout().input_at(array, slot, this->count(), bytes) + at * bytes;
  a.count = count;
  a.room = count * answer_bytes();
  a.out = out;
  return a;
}

Question Batch::question(std::size_t count) const {
  const std::size_t bytes = count * answer_bytes();
  return {piece(0, count), answers(), bytes, bytes, first()};
}

QuestionCopy Batch::ask(const Order& order, const std::string& how) const {
  QuestionCopy copy = rearranged(piece(0, 0), signature(), order);
  Fenced out(order.size() * answer_bytes(), blank_again);
  caller.guarded(copy.arguments, out, first());
  caller.compare_in_order(answers(), out.data(), answer_bytes(), order, first(), how);
  copy.answer.assign(out.data(), out.data() + out.size());
  return copy;
}

void Batch::ask_at_page(const Order& order, const std::string& how) const {
  if (order.empty()) return;
  const std::size_t bytes = order.size() * answer_bytes();
  caller.guarded_at_page(rearranged(piece(0, 0), signature(), order).arguments, bytes, blank_again, first());
  caller.compare_in_order(answers(), caller.at_guard_page(bytes), answer_bytes(), order, first(), how);
}

void Batch::ask_element(std::size_t k, const std::string& how) const {
  Fenced out(answer_bytes(), blank_again);
  caller.guarded(piece(k, 1), out, first() + k);
  caller.compare(answer(k), out.data(), 1, first() + k, how);
}

}  // namespace mmverify::dock
