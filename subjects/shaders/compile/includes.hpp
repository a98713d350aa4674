// Finds `#include "shaders/..."` of a shader.
#pragma once

#include <string>

namespace mmverify::shaders {

/// The folder that contains `shaders/`: subjects/ of the checkout, or the installed one.
std::string include_root();

}  // namespace mmverify::shaders
