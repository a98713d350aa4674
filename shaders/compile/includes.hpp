// Where `#include "shaders/..."` of a shader is found.
#pragma once

#include <string>

namespace mmverify::shaders {

/// The folder that holds `shaders/`: the checkout, or where the program is installed.
std::string include_root();

/// The folder of this program.
std::string program_folder();

}  // namespace mmverify::shaders
