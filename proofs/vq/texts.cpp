#include "proofs/vq/texts.hpp"

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

std::vector<std::uint8_t> bytes_after(std::string_view name, const std::string& text, std::size_t count) {
  const std::size_t head = name.size() + 1;
  if (text.size() == head + 2 * count && text.starts_with(name) && text[name.size()] == ':')
    if (auto bytes = bytes_from_hex(std::string_view(text).substr(head))) return *bytes;
  throw BadCase(fmt::format("'{:.60}': write {}: and {} hexadecimal digits", text, name, 2 * count));
}

}  // namespace mmverify::proofs::vq
