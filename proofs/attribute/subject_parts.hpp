// What the built-in subjects have of each part of the topic: the specification's functions, and the library's.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

Orders specified_orders();
/// impl/attribute/order.hpp, its spans and its single values.
Orders library_orders();
Orders library_orders_one_by_one();
/// W-minor and U-major with every product in 32 bits.
Orders orders_in_32_bits();
/// The rows' triplets in W-minor order as figure 4 has them, with a binary32 root; `short_root` takes the number before
/// it.
Orders figure_4_triplets(bool short_root);

Lookup specified_lookup();
/// impl/attribute/lookup.hpp, its spans and its single values.
Lookup library_lookup();
Lookup library_lookup_one_by_one();
/// The library's micro-triangle, and the specification's formula of one remap with each operation rounded to binary32.
Lookup rounded_lookup(Remap way);
/// A float lookup answers on grid points by way of binary32.
void answer_points_by_floats(Lookup& f);
Decimation specified_decimation();
Decimation library_decimation();
Mips specified_mips();
Mips library_mips();

Baking specified_baking();
Baking library_baking();

Compression specified_compression();
Compression library_compression();

}  // namespace mmverify::proofs::attribute
