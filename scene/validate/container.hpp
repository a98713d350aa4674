// The library's containers as files: each refusal of their readers gets a code.
#pragma once

#include "scene/validate/file.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {

/// The kind that the first bytes name; none if they are no container's.
std::optional<FileKind> container_kind(std::span<const unsigned char> bytes);

/// The findings of a container of that kind.  A reader stops at the first fault, so the bytes have one
/// finding at most; an intact array file has the findings of its content.
void validate_container(FileKind kind, std::span<const unsigned char> bytes, Report& report);

}  // namespace mmverify::scene
