// Describes undefined behaviour in words.
#pragma once

#include <string>

#include "subjects/source/program.hpp"

namespace mmverify::source {

/// The reason why a node's value must not be used, and its place: "shl: a shift too far, or bits lost,
/// mine.c:12".
std::string said(const Node& node);

}  // namespace mmverify::source
