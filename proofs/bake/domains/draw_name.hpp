// Names of draws, "drawn-SEED-LEVEL-NUMBER", which stand for all texels in a case's text.
#pragma once

#include <cstdio>
#include <string>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// make(seed, level, number) of a draw's name, which begins with `begins`.  Throws BadCase for a name that this case does
/// not have.
template <class Make>
Case case_named(const std::string& name, const std::string& begins, Make make) {
  unsigned long seed = 0, number = 0;
  unsigned n = 0;
  const bool is_name = name.starts_with(begins) &&
                       std::sscanf(name.c_str() + begins.size(), "%lu-%u-%lu", &seed, &n, &number) == 3 &&
                       n <= 12;
  if (is_name)
    if (Case one = make(seed, n, number); one.drawn == name) return one;
  throw BadCase("'" + name.substr(0, 60) + "': no such draw; write " + begins +
                "SEED-LEVEL-NUMBER, or the texels' digits");
}

}  // namespace mmverify::proofs::bake
