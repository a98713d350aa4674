#include "proofs/vq/texts.hpp"

#include <fmt/format.h>

#include <charconv>

namespace mmverify::proofs::vq {

std::string letters(std::span<const State> states) {
  std::string text;
  for (const State s : states) text += "TCO"[static_cast<std::size_t>(s)];
  return text;
}

std::vector<State> states_from_letters(std::string_view text, std::size_t count) {
  constexpr std::string_view alphabet = "TCO";
  if (text.size() != count || text.find_first_not_of(alphabet) != std::string_view::npos)
    throw BadCase(fmt::format("'{:.60}': write {} letters T, C or O", text, count));
  std::vector<State> states;
  for (const char letter : text) states.push_back(static_cast<State>(alphabet.find(letter)));
  return states;
}

std::string hex(std::span<const std::uint8_t> bytes) { return fmt::format("{:02x}", fmt::join(bytes, "")); }

std::vector<std::uint8_t> bytes_from_hex(const std::string& text, std::string_view name, std::size_t count) {
  const std::size_t head = name.size() + 1;
  if (text.size() != head + 2 * count || text.substr(0, name.size()) != name || text[name.size()] != ':' ||
      text.find_first_not_of("0123456789abcdef", head) != std::string::npos)
    throw BadCase(fmt::format("'{:.60}': write {}: and {} hexadecimal digits", text, name, 2 * count));
  std::vector<std::uint8_t> bytes(count);
  for (std::size_t k = 0; k < count; ++k)
    std::from_chars(text.data() + head + 2 * k, text.data() + head + 2 * k + 2, bytes[k], 16);
  return bytes;
}

}  // namespace mmverify::proofs::vq
