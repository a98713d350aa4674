// The codes of a primitive's micromapIndices: read, and written back.
#pragma once

#include <vector>

#include "impl/micromap/micromap.hpp"
#include "scene/edit/edited_file.hpp"

namespace mmverify::scene {

/// A triangle's index, whatever its encoding: a number from 0; -1 T, -2 O, -3 UT, -4 UO.
using Code = std::int64_t;
constexpr Code special(impl::micromap::State state) { return ~static_cast<Code>(state); }
constexpr bool is_special(Code code) { return code < 0; }

/// The link of a primitive to its micromap.
struct LinkedPrimitive {
  std::size_t mesh = 0, number = 0;  ///< meshes[mesh].primitives[number]
  std::size_t micromap = 0;
  std::uint32_t base = 0;
  std::optional<std::size_t> accessor;  ///< of its indices; none: triangle t has index t
  impl::micromap::Encoding encoding = impl::micromap::Encoding::u32;
  std::vector<Code> codes;  ///< by triangle
};

/// All primitives with a micromap.  Domain: a file without findings of validate_micromaps().
std::vector<LinkedPrimitive> linked_primitives(const EditedFile& file, const Document& document,
                                               const Buffers& buffers);

/// Writes the codes of `to`: in place where nothing else reads them, else as a new accessor.  Codes beyond the encoding's
/// get a wider one.  `others`: the file's primitives, whose codes stay as they are there.
void write_codes(EditedFile& file, const LinkedPrimitive& to, const std::vector<LinkedPrimitive>& others);

/// The extension's object on a primitive.
nlohmann::json& extension_of(EditedFile& file, std::size_t mesh, std::size_t number);

}  // namespace mmverify::scene
