// A shared library's baker of attribute maps.
#pragma once

#include "dock/library.hpp"
#include "proofs/attribute/bake/functions.hpp"

namespace mmverify::proofs::attribute {

/// What the library has of it, each call in the dock.
Baking baking_of(const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::attribute
