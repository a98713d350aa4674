#include "proofs/attribute/lookup/hats.hpp"

#include <fmt/format.h>

#include "proofs/attribute/elements.hpp"

namespace mmverify::proofs::attribute {
namespace {

template <class Name>
std::string joined(const Hats& hats, Name name) {
  std::string text;
  for (const auto& [place, weight] : hats)
    text += fmt::format("{}{} of {}", text.empty() ? "" : " + ", weight, name(place));
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::string text_of(const Hats& hats) {
  return joined(hats, [](std::uint64_t place) { return text_of(spec::attribute::w_minor_vertex(place)); });
}

std::string text_of_places(const Hats& hats) {
  return joined(hats, [](std::uint64_t place) { return fmt::format("vertex {}", place); });
}

}  // namespace mmverify::proofs::attribute
