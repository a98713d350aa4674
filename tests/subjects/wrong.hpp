// What is wrong of a library: its source is compiled once, and linked with each of the things that can be.
#pragma once

#include <string_view>

/// Linked in (tests/CMakeLists.txt).
extern "C" const char wrong_thing[];

inline bool wrong_is(std::string_view thing) { return thing == wrong_thing; }
