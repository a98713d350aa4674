// The triangles of lists, strips and fans.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace mmverify::scene {

enum class Topology { list, strip, fan };

/// The triangles of a primitive with the vertices v_0 v_1 ... in order
///   list   p_i = {v_3i, v_3i+1, v_3i+2}
///   strip  p_i = {v_i, v_i+1+i%2, v_i+2-i%2}
///   fan    p_i = {v_i+1, v_i+2, v_0}
/// Each triangle keeps the order of its vertices, since a micromap depends on it.  Vertices left over are
/// dropped.
/// Source: glTF 2.0, 3.7.2.1.
std::vector<Triangle> triangles(Topology topology, std::span<const std::uint32_t> vertices);

}  // namespace mmverify::scene
