// The parts of topic micromap's foreign subjects, each with its rows.
#pragma once

#include "tests/foreign/inside.hpp"

namespace mmverify::tests::foreign {

// Special indices and judges of substitutions.
InsideFaults faults_of_codes();
InsideFaults right_codes();
// Arrays from maps.
InsideFaults faults_of_builders();
InsideFaults right_builders();
// Violations of arrays.
InsideFaults faults_of_validators();
InsideFaults right_validators();

}  // namespace mmverify::tests::foreign
