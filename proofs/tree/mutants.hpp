// Tree subjects that are broken on purpose.
#pragma once

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

using Change = std::function<void(Functions&)>;
/// A built-in subject with one thing broken on purpose.
inline constexpr auto mutant = mutant_of<built_in_subjects>;

// One function's answers, changed; `map` is the one that the code is of.
Change encodes_another(std::function<void(Map& map)> spoil);
Change decodes_wrongly(std::function<void(const Map& map, Bytes& decoded)> spoil);
Change finds_wrongly(std::function<void(const Map& map, std::uint32_t index, std::uint8_t& state)> spoil);
Change finds_points_wrongly(std::function<void(const Map& map, float u, float v, std::uint8_t& state)> spoil);
Change writes_wrongly(std::function<void(const Map& map, Bytes& bytes)> spoil);
/// `real` is the unbroken subject, and `code` what it makes of the bytes.
Change opens_wrongly(
    std::function<std::optional<Code>(const Functions& real, Level n, Format f,
                                      std::span<const std::uint8_t> bytes, std::optional<Code> code)>
        instead);

}  // namespace mmverify::proofs::tree
