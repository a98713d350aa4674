// The parts of topic micromap's foreign subjects, each with its rows.
#pragma once

#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {

// Special indices and judges of substitutions.
InsideRows faults_of_codes();
InsideRows right_codes();
// Arrays from maps.
InsideRows faults_of_builders();
InsideRows right_builders();
// Violations of arrays.
InsideRows faults_of_validators();
InsideRows right_validators();

}  // namespace mmverify::tests::foreign
