// The fault of a wrong library: its source is compiled once, and linked with the name of each fault.
#pragma once

#include <string_view>

/// Linked in (tests/CMakeLists.txt).
extern "C" const char wrong_thing[];

inline bool wrong_is(std::string_view thing) { return thing == wrong_thing; }
