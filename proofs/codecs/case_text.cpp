#include "proofs/codecs/case_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace mmverify::proofs::codecs {
namespace {

std::string begin_of(const Chosen& group) { return group.name.empty() ? ":" : "," + group.name + "="; }

std::string written(const Chosen& group, std::uint64_t number) {
  if (group.written == Written::bytes) return fmt::format("{:02x}", number);
  return fmt::format("{}", number);
}

/// Takes the number at the beginning of a text; nothing if there is none below 2^bits.
std::optional<std::uint64_t> taken(const Chosen& group, std::string_view& text) {
  const bool bytes = group.written == Written::bytes;
  const std::size_t length = group.written == Written::number ? text.size() : bytes ? 2 : 1;
  if (text.size() < length) return std::nullopt;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + length, number, bytes ? 16 : 10);
  if (error != std::errc() || (group.bits < 64 && number >> group.bits != 0)) return std::nullopt;
  const auto used = static_cast<std::size_t>(end - text.data());
  if (group.written != Written::number && used != length) return std::nullopt;
  text.remove_prefix(used);
  return number;
}

}  // namespace

std::string text_of(const Question& question, const std::vector<std::uint64_t>& numbers) {
  std::string text = question.begins;
  std::size_t at = 0;
  for (const Chosen& group : question.chosen) {
    text += begin_of(group);
    for (std::uint64_t k = 0; k < group.count; ++k) text += written(group, numbers.at(at++));
  }
  return text;
}

std::optional<std::vector<std::uint64_t>> numbers_of(const Question& question, const std::string& whole) {
  std::string_view text = whole;
  const auto skips = [&](const std::string& begin) {
    if (!text.starts_with(begin)) return false;
    text.remove_prefix(begin.size());
    return true;
  };
  if (!skips(question.begins)) return std::nullopt;
  std::vector<std::uint64_t> numbers;
  for (const Chosen& group : question.chosen) {
    if (!skips(begin_of(group))) return std::nullopt;
    for (std::uint64_t k = 0; k < group.count; ++k) {
      const auto number = taken(group, text);
      if (!number) return std::nullopt;
      numbers.push_back(*number);
    }
  }
  return text.empty() ? std::optional(numbers) : std::nullopt;
}

std::uint64_t count_of(const Question& question) {
  std::uint64_t count = 0;
  for (const Chosen& group : question.chosen) count += group.count;
  return count;
}

}  // namespace mmverify::proofs::codecs
