// The picture of docs/ATTRIBUTE_SCENES.md, "Mips and bleeding".
#pragma once

#include <string>

namespace mmverify::tests {

/// An atlas of our own with three charts, mip by mip: the texture's, faces and vertices of about as many values.
std::string attribute_bleeding();

}  // namespace mmverify::tests
