// The picture of docs/SUBDIVISION.md.
#pragma once

#include <string>

namespace mmverify::tests {

/// The cells and the curve of each scheme; steps over a point alone are marked.
std::string subdivision_curves();

}  // namespace mmverify::tests
