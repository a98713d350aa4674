// The pictures of docs/ATTRIBUTE.md: figures 2 and 3 of Color and Attribute Micromaps, drawn from the specification.
#pragma once

#include <string>

namespace mmverify::tests {

/// Figure 2: the indices of micro-vertices and of micro-triangles at level 2, in each of the three orders.
std::string attribute_orders();

/// Figure 3: levels 1 and 2 with each set of flags.
std::string attribute_decimation();

}  // namespace mmverify::tests
