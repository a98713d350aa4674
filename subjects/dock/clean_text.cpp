#include "subjects/dock/clean_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace mmverify::dock {
namespace {

struct Character {
  std::size_t bytes;  ///< 0 if no UTF-8 begins here
  std::uint32_t code;
};

/// The first character of the text. Domain: at least one byte.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (byte(0) < 0x80) return {1, byte(0)};
  const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < bytes) return {0, 0};
  std::uint32_t code = byte(0) & (0xffu >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xc0) != 0x80) return {0, 0};
    code = code << 6 | (byte(k) & 0x3f);
  }
  // Overlong forms, surrogates, and numbers beyond Unicode.
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {0, 0};
  return {bytes, code};
}

/// Whether a terminal or viewer acts on the character instead of showing it.
bool is_obeyed(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return code < 0x20 || within(0x7f, 0x9f) || within(0x200e, 0x200f) || within(0x2028, 0x202e) ||
         within(0x2066, 0x2069) || code == 0x61c || code == 0xfeff;
}

}  // namespace

std::string clean_text(std::string_view bytes) {
  std::string clean;
  const auto write_out = [&](std::string_view some) {
    for (const char c : some) clean += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  };
  for (std::size_t at = 0; at < bytes.size();) {
    const std::string_view rest = bytes.substr(at);
    const Character c = first_character(rest);
    const std::size_t size = c.bytes == 0 ? 1 : c.bytes;
    const bool begins_command =
        (at == 0 && rest.starts_with("::")) || (c.code == '#' && clean.ends_with('#'));
    if (c.bytes == 0 || is_obeyed(c.code) || begins_command)
      write_out(rest.substr(0, size));
    else
      clean += rest.substr(0, size);
    at += size;
  }
  return clean;
}

std::string clean_lines(std::string_view bytes) {
  std::string clean;
  for (std::size_t at = 0; at <= bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    clean += (at == 0 ? "" : "\n") + clean_text(bytes.substr(at, end - at));
    at = end + 1;
  }
  return clean;
}

}  // namespace mmverify::dock
