// Asks again over an output that holds something already. A subject that adds to it, or that takes for answered
// what looks like it, is right over an output of one byte's repetitions.
#include <algorithm>
#include <array>
#include <span>

#include "subjects/dock/desk/provocations.hpp"

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
    case Prior::right_ends: return k == 0 || k + 1 == count;
    case Prior::right_first_half: return k < (count + 1) / 2 || k + 1 == count;
    case Prior::right_last_half: return k == 0 || k >= count / 2;
    case Prior::right_every_other: return k % 2 == 0;
    default: return false;
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

}  // namespace

void over_answers(const Batch& batch) {
  const std::span<const std::byte> right(batch.answers(), batch.whole().bytes);
  const std::vector<std::byte> another =
      gathered(right.data(), batch.answer_bytes(), turned_by_half(batch.count()));
  for (const Prior prior : of_numbers) {
    Fenced out(right.size(), blank_again);
    lay(prior, right, another, batch.signature().value_bytes, out.data());
    batch.caller.guarded(batch.piece(0, batch.count()), out, batch.first());
    batch.caller.compare(right.data(), out.data(), batch.count(), batch.first(), asked_over);
  }
}

void over_answers(const Blob& blob) {
  if (blob.size == 0) return;
  std::vector<std::byte> another = gathered(blob.answer.data(), 1, turned_by_half(blob.answer.size()));
  if (const auto& last = blob.kept.last[blob.caller.entry_number()];
      last && !last->answer.empty() && last->answer != blob.answer)
    for (std::size_t k = 0; k < another.size(); ++k) another[k] = last->answer[k % last->answer.size()];
  for (std::size_t k = 0; k < of_bytes.size(); ++k) {
    if (blob.before() >= first_over_all && blob.before() % of_bytes.size() != k) continue;
    Fenced out(blob.answer.size(), blank_again);
    lay(of_bytes[k], blob.answer, another, 1, out.data());
    blob.ask_into(out, blob.bytes, asked_over);
  }
}

}  // namespace mmverify::dock
