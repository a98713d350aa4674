// Points that the laws of topic index range over: cells of a grid, rationals, floats as exact numbers, hard floats.
#pragma once

#include "proofs/points/exact_float.hpp"
#include "proofs/points/hard_floats.hpp"

namespace mmverify::proofs::index {

using namespace points;

}  // namespace mmverify::proofs::index
