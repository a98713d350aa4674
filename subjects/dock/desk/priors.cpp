// Asks again over an output that holds something already. A subject that adds to it, or that takes for answered
// what looks like it, is right over an output of one byte's repetitions.
#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

constexpr char asked_over[] = "asked with another answer in its output";

/// The numbers that an output holds before a call: all are another question's, or some are right already.
enum class Prior {
  another,
  right_ends,
  right_first_half,
  right_last_half,
  right_every_other,
  zeros_then_ones,
  ones_then_zeros
};
constexpr std::array of_bytes{Prior::another,         Prior::right_ends,        Prior::right_first_half,
                              Prior::right_last_half, Prior::right_every_other, Prior::zeros_then_ones,
                              Prior::ones_then_zeros};
/// Halves of zeros and of ones are for bytes alone.
constexpr std::span of_numbers = std::span(of_bytes).first<5>();
/// The first questions of a kind are asked over each; later ones over one in turn.
constexpr std::uint32_t first_over_all = 16;

/// Whether number k of `count` is right. The first and the last one are right as well where a half is.
bool is_right(Prior prior, std::size_t k, std::size_t count) {
  switch (prior) {
    case Prior::right_ends:
      return k == 0 || k + 1 == count;
    case Prior::right_first_half:
      return k < (count + 1) / 2 || k + 1 == count;
    case Prior::right_last_half:
      return k == 0 || k >= count / 2;
    case Prior::right_every_other:
      return k % 2 == 0;
    default:
      return false;
  }
}

/// Lays the prior over `out`, numbers of `wide` bytes. Domain: all three have the same size.
void lay(Prior prior, std::span<const std::byte> right, std::span<const std::byte> another, std::size_t wide,
         std::byte* out) {
  const std::size_t size = right.size(), count = size / wide;
  if (prior == Prior::zeros_then_ones || prior == Prior::ones_then_zeros) {
    constexpr std::byte zero{0}, full{0xff};
    const std::size_t half = size / 2;
    std::fill(out, out + half, prior == Prior::zeros_then_ones ? zero : full);
    std::fill(out + half, out + size, prior == Prior::zeros_then_ones ? full : zero);
    return;
  }
  for (std::size_t k = 0; k < size; ++k) out[k] = (is_right(prior, k / wide, count) ? right : another)[k];
}

/// The answers, each in the place of one that is half of them away.
std::vector<std::byte> turned_by_half(std::span<const std::byte> answers, std::size_t wide) {
  const std::size_t count = answers.size() / wide;
  return gathered(answers.data(), wide, count, [=](std::size_t k) { return (k + count / 2) % count; });
}

}  // namespace

void Desk::ask_slot_over_answers(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes;
  const std::span right(slot_answer(slot), count * wide);
  const std::vector<std::byte> another = turned_by_half(right, wide);
  for (const Prior prior : of_numbers) {
    Fenced out(count * wide, blank_again);
    lay(prior, right, another, asked().signature.value_bytes, out.data());
    guarded(piece(slot, 0, count, nullptr), out, from);
    compare(right.data(), out.data(), count, from, asked_over);
  }
}

void Desk::ask_blob_over_answers(const std::uint8_t* blob, std::uint64_t size) {
  if (size == 0) return;
  std::vector<std::byte> another = turned_by_half(again_, 1);
  if (const auto& earlier = earlier_[static_cast<std::size_t>(mailbox_.call)];
      earlier && !earlier->answer.empty() && earlier->answer != again_)
    for (std::size_t k = 0; k < another.size(); ++k) another[k] = earlier->answer[k % earlier->answer.size()];
  const std::uint32_t before = mailbox_.asked_before;
  for (std::size_t k = 0; k < of_bytes.size(); ++k) {
    if (before >= first_over_all && before % of_bytes.size() != k) continue;
    Fenced out(again_.size(), blank_again);
    lay(of_bytes[k], again_, another, 1, out.data());
    ask_blob_into(out, blob, size, asked_over);
  }
}

}  // namespace mmverify::dock
