// Lookups in the form for random access, from its memory.  Internal to impl/tree.
#pragma once

#include <cstddef>
#include <cstdint>

#include "impl/tree/tree.hpp"

namespace mmverify::impl::tree::detail {

/// The state at an index, whose low bits count.  Domain: memory of a Tree.
std::uint8_t find(const std::uint8_t* memory, std::uint64_t index) noexcept;

/// state[k] = find(memory, index[k]) for k < count.
void find_each(const std::uint8_t* memory, const std::uint32_t* index, std::uint8_t* state,
               std::size_t count) noexcept;

/// state[k] = find(trees[which[k]]->memory(), index[k]) for k < count.
void find_in_many(const Tree* const* trees, const std::uint32_t* which, const std::uint32_t* index,
                  std::uint8_t* state, std::size_t count) noexcept;

}  // namespace mmverify::impl::tree::detail
