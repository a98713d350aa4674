// Points that the laws of topic index range over: cells of a grid, rationals, floats as exact numbers, stiff floats.
#pragma once

#include "proofs/points/exact_float.hpp"
#include "proofs/points/stiff_floats.hpp"

namespace mmverify::proofs::index {

using namespace points;

}  // namespace mmverify::proofs::index
