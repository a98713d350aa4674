// Every statement that ships, under its path in proofs/statements.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "proofs/attribute/induction/provable.hpp"
#include "proofs/dag/induction/provable.hpp"
#include "proofs/index/binary32/law.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/tree/induction/provable.hpp"

namespace mmverify::tests {

inline std::map<std::string, proofs::induction::Statement> shipped_statements() {
  std::map<std::string, proofs::induction::Statement> all;
  const auto add = [&](const std::string& folder, const auto& statements) {
    for (const auto& s : statements) all.emplace(folder + "/" + s.name + ".smt2", s);
  };
  add("index/all_levels", proofs::index::induction::shipped_all_levels());
  add("index/wide_is_vulkan", proofs::index::induction::shipped_wide_is_vulkan());
  add("index/impl_wide_is_wide", proofs::index::induction::shipped_impl_wide());
  add("index/floats", proofs::index::binary32::shipped());
  add("index/row_floats", proofs::index::binary32::shipped_rows());
  add("index/published_differs_where", proofs::index::binary32::shipped_published());
  add("tree/all_levels", proofs::tree::induction::shipped_all_levels());
  add("dag/all_levels", proofs::dag::induction::shipped_all_levels());
  add("attribute/w_minor_all_levels", proofs::attribute::induction::shipped_w_minor());
  add("attribute/u_major_all_levels", proofs::attribute::induction::shipped_u_major());
  add("attribute/bird_all_levels", proofs::attribute::induction::shipped_bird());
  add("attribute/faces_all_levels", proofs::attribute::induction::shipped_faces());
  return all;
}

inline std::string read(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace mmverify::tests
