// From a map to the form for random access, and back.  Internal to impl/tree.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "impl/tree/tree.hpp"

namespace mmverify::impl::tree::detail {

/// The memory of a map's form, as Tree::encode; with `depths` if given, else with those that suit the map.
std::unique_ptr<std::uint8_t[]> encode_form(Level n, Format b, std::span<const std::uint8_t> map,
                                            std::optional<Tree::Depths> depths);

/// Writes the map of a form.  Domain: a map of the level's size.
void decode_form(const std::uint8_t* memory, std::span<std::uint8_t> map);

/// Writes the map if a faster way exists for this form; else writes nothing and returns false.
struct Layout;
bool decode_without_steps(const Layout& layout, std::span<const std::uint8_t> all, std::uint8_t* map);

}  // namespace mmverify::impl::tree::detail
