// Points with their exact micro-triangles, from the file mmverify_vectors.bin.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rays {

/// A point and the micro-triangle that holds it.
struct Point {
  std::uint32_t level = 0;
  float u = 0, v = 0;                  ///< weights of the second and the third vertex
  bool tie = false;                    ///< on an edge or a vertex of the grid
  float gap = 0;                       ///< distance to the next grid line, in micro-triangle edges
  std::uint32_t index = 0;             ///< of the micro-triangle, exact
  std::vector<std::uint32_t> touched;  ///< every micro-triangle that the point touches
  std::string about;                   ///< why the vector is there
};

/// The points of table `index.points` that lie in the triangle, and the centroids of table `corners.curve`.
/// Throws std::runtime_error that names the file.
std::vector<Point> read_points(const std::string& path);

}  // namespace rays
