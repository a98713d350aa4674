// A reader of typed elements from buffers, none beyond its bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/read/buffers.hpp"

namespace mmverify::scene {

/// The integers that may stand for floats.  glTF alone: none in positions, unsigned normalised ones in UVs
/// and colours.  KHR_mesh_quantization: any of 8 and 16 bits.
enum class Integers { none, unsigned_normalised, any };

/// Component c of element k is values[components k + c], as float32.
///   unsigned normalised c / (2^b - 1), signed max(c / (2^(b-1) - 1), -1), each rounded once
/// Sparse accessors are filled in; without a view, elements are zero.
/// `decoded`: the elements, tightly packed, if they stand compressed in the file and not in the accessor's view.
/// `at` names the reader of the values ("mesh 2 primitive 0 TEXCOORD_0").  Domain: index names an accessor.
/// Errors: BadScene if the accessor's type has not `components` components, its component type is not
/// allowed, it has no elements or more than 2^26 (2^22 without a view), it reaches beyond its view or a view
/// beyond its buffer, or a value is not finite.
/// Source: glTF 2.0, 3.6.2 and 3.11; KHR_mesh_quantization.
std::vector<float> read_floats(const Document& document, const Buffers& buffers, std::size_t index,
                               int components, Integers integers, const std::string& at,
                               const Bytes* decoded = nullptr);

/// The indices of a primitive.  Errors: BadScene as above, if they are not unsigned scalars, or if one is the
/// largest of its type, which restarts a primitive.  Source: glTF 2.0, 3.7.2.1.
std::vector<std::uint32_t> read_indices(const Document& document, const Buffers& buffers, std::size_t index,
                                        const std::string& at, const Bytes* decoded = nullptr);

}  // namespace mmverify::scene
