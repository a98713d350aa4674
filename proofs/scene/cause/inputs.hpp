// The inputs that expected maps are baked from.
#pragma once

#include <vector>

#include "proofs/engine/result.hpp"
#include "proofs/scene/cause/cause.hpp"
#include "proofs/scene/cause/fit.hpp"

namespace mmverify::proofs::scene {

/// Surfaces and UVs of the triangles, which a change alters.
struct Inputs {
  std::vector<mmverify::scene::Surface> surfaces;  ///< by surface of the plan
  std::vector<mmverify::scene::UvTriangle> uvs;    ///< by triangle
};
Inputs inputs_of(const Judged& judged);

/// Ends a search: throws Interrupted after a signal, OutOfTime after Judged::until.
void stop_if_due(const Judged& judged);

/// The exact maps of some triangles at the levels of their stored maps; in the order of `triangles`.
std::vector<States> expected(const Judged& judged, const Inputs& inputs,
                             const std::vector<std::size_t>& triangles);

/// The exact map of one triangle at another level.
States expected_at(const Judged& judged, const Inputs& inputs, std::size_t triangle, Level n);

}  // namespace mmverify::proofs::scene
