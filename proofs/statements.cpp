#include "proofs/statements.hpp"

#include "proofs/attribute/induction/provable.hpp"
#include "proofs/dag/induction/provable.hpp"
#include "proofs/index/binary32/law.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/tree/induction/provable.hpp"

namespace mmverify::proofs {

std::map<std::string, induction::Statement> shipped_statements() {
  std::map<std::string, induction::Statement> all;
  const auto add = [&](const std::string& folder, const auto& statements) {
    for (const auto& s : statements) all.emplace(folder + "/" + s.name, s);
  };
  add("index/all_levels", index::induction::shipped_all_levels());
  add("index/wide_is_vulkan", index::induction::shipped_wide_is_vulkan());
  add("index/impl_wide_is_wide", index::induction::shipped_impl_wide());
  add("index/floats", index::binary32::shipped());
  add("index/row_floats", index::binary32::shipped_rows());
  add("index/published_differs_where", index::binary32::shipped_published());
  add("tree/all_levels", tree::induction::shipped_all_levels());
  add("dag/all_levels", dag::induction::shipped_all_levels());
  add("attribute/w_minor_all_levels", attribute::induction::shipped_w_minor());
  add("attribute/u_major_all_levels", attribute::induction::shipped_u_major());
  add("attribute/bird_all_levels", attribute::induction::shipped_bird());
  add("attribute/faces_all_levels", attribute::induction::shipped_faces());
  return all;
}

}  // namespace mmverify::proofs
