// Parts of the built-in subjects of topic attribute: the specification's functions, and the library's.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

Orders specified_orders();
/// The orders of impl/attribute/order.hpp, by spans and one value at a time.
Orders library_orders();
Orders library_orders_one_by_one();
/// W-minor and U-major with every product in 32 bits.
Orders orders_in_32_bits();
/// The rows' triplets in W-minor order as figure 4 prints them, with a binary32 root.  `short_root`: the root is the
/// number before.
Orders figure_4_triplets(bool short_root);

Lookup specified_lookup();
/// The lookups of impl/attribute/lookup.hpp, by spans and one value at a time.
Lookup library_lookup();
Lookup library_lookup_one_by_one();
/// The library's micro-triangle with the specification's formula of one remap, each operation rounded to binary32.
Lookup rounded_lookup(Remap way);
/// Answers grid points through the float lookups.
void answer_points_by_floats(Lookup& f);
Decimation specified_decimation();
Decimation library_decimation();
Mips specified_mips();
Mips library_mips();

Baking specified_baking();
Baking library_baking();

Compression specified_compression();
Compression library_compression();

/// The library's baking functions; each call runs in the dock.
Baking baking_of(const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::attribute
