// The accessor of micromapIndices: its JSON, and its elements as bytes.
#pragma once

#include "scene/validate/report.hpp"

namespace mmverify::scene {

struct MicromapIndices {
  impl::micromap::Encoding encoding = impl::micromap::Encoding::u32;
  std::uint64_t address = 0;  ///< offset of the first element in its buffer
  std::uint64_t count = 0;
  std::span<const unsigned char> bytes;  ///< into a buffer, or into `own`
  Bytes own;                             ///< elements that are nowhere in the file as they are
};

/// The elements of the existing accessor `index`; none if they cannot be read, which `report` then explains.
/// Findings are at `pointer`, the property that names the accessor, or at the accessor's own.
std::optional<MicromapIndices> read_micromap_indices(const Document& document, const Buffers& buffers,
                                                     std::size_t index, const std::string& pointer,
                                                     Report& report);

}  // namespace mmverify::scene
