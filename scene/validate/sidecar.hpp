// Raw arrays: the buffers of a build as files, and a JSON file beside them that says what is where.
#pragma once

#include "scene/validate/file.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {

/// Findings of a sidecar (docs/VALIDATE.md, docs/array.schema.json) and of the buffers that it names.
/// What cannot be read is not judged further: the cause is listed.
void validate_sidecar(std::span<const unsigned char> bytes, const Beside& beside, Report& report);

/// An array and its geometries: the array's violations once, then each geometry's; one histogram handed over for the
/// other is one line, in the place of its counts.
/// `array` has no geometry; of `geometries` the array's members are not looked at.
/// Cost: O(n log n) in the array, which is looked at once, and linear in the triangles that each geometry has indices
/// for.
void validate_build(const impl::micromap::Input& array, std::span<const impl::micromap::Input> geometries,
                    Report& report);

}  // namespace mmverify::scene
