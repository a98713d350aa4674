// Mistakes that bakers make throughout: a case taken for another one.
#pragma once

#include <vector>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

struct KnownMistake {
  const char* as_if;  ///< "rows of texels came from below"
  void (*mistake)(Case&);
};

/// Each leaves some cases as they are.
const std::vector<KnownMistake>& known_mistakes();

}  // namespace mmverify::proofs::bake
