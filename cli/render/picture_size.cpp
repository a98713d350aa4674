#include "cli/render/picture_size.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>

namespace mmverify::cli {
namespace {

constexpr std::uint32_t longest_side = 4096;

/// A side without sign or leading zeros.
std::optional<std::uint32_t> side_of(std::string_view text) {
  std::uint32_t side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (error != std::errc{} || end != text.data() + text.size() || side > longest_side || text.front() == '0')
    return std::nullopt;
  return side;
}

std::optional<PictureSize> size_of(std::string_view text) {
  const auto x = text.find('x');
  if (x == std::string_view::npos) return std::nullopt;
  const auto width = side_of(text.substr(0, x)), height = side_of(text.substr(x + 1));
  if (!width || !height) return std::nullopt;
  return PictureSize{*width, *height};
}

std::string fault_of(const std::string& text) {
  return size_of(text) ? "" : fmt::format("{:.40}: write WIDTHxHEIGHT, each 1 to {}", text, longest_side);
}

}  // namespace

void add_picture_size(CLI::App& command, PictureSize& size) {
  command
      .add_option_function<std::string>(
          "--size", [&size](const std::string& text) { size = *size_of(text); },
          "size of the picture in pixels; 640x480 where not given")
      ->check(fault_of)
      ->type_name("WIDTHxHEIGHT");
}

}  // namespace mmverify::cli
