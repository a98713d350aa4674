// The validator of raw arrays: the buffers of a build as files, and a JSON file beside them that locates the
// parts.
#pragma once

#include "scene/validate/file.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {

/// Reports the findings of a sidecar (docs/VALIDATE.md, docs/array.schema.json) and of the buffers that it
/// names.
/// A part that cannot be read is not judged further: the cause is listed.
void validate_sidecar(std::span<const unsigned char> bytes, const Beside& beside, Report& report);

/// Reports an array's violations once, then each geometry's.  A histogram given in place of the other kind is
/// one finding, at its counts.
/// `array` has no geometry; the array's members of `geometries` are ignored.  The device has what no array has: its
/// features and pipelines.
/// Cost: O(n log n) in the array, which is read once, and linear in the triangles for which each geometry has
/// indices.
void validate_build(const impl::micromap::Input& array, std::span<const impl::micromap::Input> geometries,
                    const Device& device, Report& report);

}  // namespace mmverify::scene
