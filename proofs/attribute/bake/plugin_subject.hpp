// The baker of attribute maps of a shared library.
#pragma once

#include "proofs/attribute/bake/functions.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::attribute {

/// The library's baking functions; each call runs in the dock.
Baking baking_of(const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::attribute
