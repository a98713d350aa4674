// A result of each topic, with figures enough for every table: the schema is made of their columns.
#pragma once

#include <vector>

#include "bench/result.hpp"

namespace mmverify::bench {

/// Results of the topics that one call of `mmverify bench` measures together.
std::vector<Result> examples_of_topics();

/// Results of the other benches; a topic with different tables has several.
std::vector<Result> other_examples();

}  // namespace mmverify::bench
