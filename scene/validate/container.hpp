// The library's containers as files: what their readers refuse, told apart.
#pragma once

#include "scene/validate/file.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {

/// The kind that the first bytes say; none where they are no container's.
std::optional<FileKind> container_kind(std::span<const unsigned char> bytes);

/// Findings of a container of that kind.  A reader stops at the first fault, so there is one finding of its bytes; of an
/// array file that is whole, those of its content.
void validate_container(FileKind kind, std::span<const unsigned char> bytes, Report& report);

}  // namespace mmverify::scene
