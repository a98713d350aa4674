#include "proofs/attribute/subject.hpp"

#include "proofs/attribute/subject_parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

AttributeSubjectPtr subject(const char* name, const char* about, const Functions& functions) {
  return std::make_shared<AttributeSubject>(name, about, functions);
}

/// Each part of the topic has its line here.
AttributeSubjectPtr specified() {
  Functions f;
  f.orders = specified_orders();
  f.lookup = specified_lookup();
  f.decimation = specified_decimation();
  f.mips = specified_mips();
  f.baking = specified_baking();
  f.compression = specified_compression();
  return subject("attribute-spec", "the specification, in whole numbers and rationals", f);
}

AttributeSubjectPtr library() {
  Functions f;
  f.exact = false;
  f.orders = library_orders();
  f.lookup = library_lookup();
  f.decimation = library_decimation();
  f.mips = library_mips();
  f.baking = library_baking();
  f.compression = library_compression();
  return subject("attribute", "this project's library, in batches and binary32", f);
}

AttributeSubjectPtr library_one_by_one() {
  Functions f;
  f.exact = false;
  f.orders = library_orders_one_by_one();
  f.lookup = library_lookup_one_by_one();
  return subject("attribute-single", "this project's library, one value at a time", f);
}

AttributeSubjectPtr of_orders(const char* name, const char* about, Orders orders) {
  Functions f;
  f.orders = std::move(orders);
  return subject(name, about, f);
}

AttributeSubjectPtr of_remap(const char* name, const char* about, Remap way) {
  Functions f;
  f.exact = false;
  f.lookup = rounded_lookup(way);
  return subject(name, about, f);
}

}  // namespace

const std::vector<AttributeSubjectPtr>& built_in_subjects() {
  static const std::vector<AttributeSubjectPtr> all{
      specified(),
      library(),
      library_one_by_one(),
      of_orders("attribute-32-bit", "W-minor and U-major with every product in 32 bits", orders_in_32_bits()),
      of_orders("attribute-figure-4", "triplets of rows by figure 4, its root in binary32",
                figure_4_triplets(false)),
      of_orders("attribute-short-root", "the same, the root one number short, as Vulkan lets it be",
                figure_4_triplets(true)),
      of_remap("attribute-cramer-f32", "weights by the 3x3 system and Cramer's rule, in binary32",
               Remap::cramer),
      of_remap("attribute-two-f32", "weights by two of its equations, in binary32", Remap::two),
  };
  return all;
}

}  // namespace mmverify::proofs::attribute
