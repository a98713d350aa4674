// Tables of the hits of a scene's rays, method by method.
#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"
#include "display/render/scene/compare.hpp"

namespace mmverify::bench {

/// A picture that a run wrote.
struct RenderPictureFile {
  std::string shows;  ///< "seen", "blended" or "heat"
  std::string file;   ///< a path from the folder in which the program was called, or an absolute one
};

struct RenderFigures {
  std::string file;
  unsigned states = 4, ambient = 0;             ///< states of maps; rays of ambient occlusion from each hit
  std::uint64_t triangles = 0, placed = 0;      ///< of the scene
  std::uint64_t tested = 0, tested_placed = 0;  ///< triangles that get micromaps
  std::uint64_t unplanned = 0;                  ///< triangles that a texture tests, but the plan leaves out
  std::uint32_t width = 0, height = 0;
  std::uint64_t camera = 0, seed = 0, threads = 0;
  std::string embree;
  std::vector<render::MethodFigures> methods;  ///< the first is texture
  std::vector<render::BlendFigures> blends;    ///< none if no hits blend; else the first is texture
  std::string operation,
      colours;  ///< the operation of blending, and the elements with colours: "faces" or "vertices"
  std::uint64_t colour_level = 0, colour_bytes = 0;
  std::vector<RenderPictureFile> pictures;
};

/// The tables of methods.  Source: Succinct Opacity Micromaps, 5.2 and table 3; Compressed Opacity Maps,
/// figures 1 and 12.
/// Domain: at least one method.
Result render_tables(const RenderFigures& figures);

}  // namespace mmverify::bench
