// Laws that a prover settles: the shipped statements, with one thing altered in the text.
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "proofs/index/floats/published.hpp"
#include "proofs/induction/discharge.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/tree/subject.hpp"
#include "tests/foreign/inside/curve.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {
namespace {

using proofs::induction::Answer;
using proofs::induction::Provable;
using proofs::induction::Statement;
using Statements = std::vector<Statement>;

/// The statements in a law's folder.
Statements shipped(const std::string& folder) {
  Statements all;
  for (const auto& [path, statement] : proofs::shipped_statements())
    if (path.starts_with(folder + "/")) all.push_back(statement);
  return all;
}

/// Row order's own, and those of the first steps, which it shares with the index on the curve.
Statements rows() {
  Statements all = shipped("index/row_floats");
  for (Statement& s : shipped("index/floats")) {
    const std::string step = s.name.substr(s.name.find('_') + 1);
    if (s.name == "side" || step == "scale" || step == "parts" || step == "carry" || step == "flush")
      all.push_back(std::move(s));
  }
  return all;
}

/// One of the folder's statements with the first place of `before` replaced: it alone, as the others are right
/// and cost seconds.
Statements altered(const std::string& folder, const std::string& name, const std::string& before,
                   const std::string& after) {
  Statements all = shipped(folder);
  for (Statement& s : all) {
    if (s.name != name) continue;
    const std::size_t at = s.text.find(before);
    if (at == std::string::npos) break;
    s.text.replace(at, before.size(), after);
    return {std::move(s)};
  }
  throw std::logic_error("no statement " + name + " with " + before);
}

/// Vulkan's formula, right on every point.
proofs::index::Functions functions_of_the_curve() {
  using proofs::points::RationalPoint;
  proofs::index::Functions functions;
  functions.index = [](Level n, proofs::index::Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = static_cast<std::uint32_t>(vulkan(whole_numbers(batch.points[t]), n, Fault::none));
  };
  functions.index_at = [](Level n, const RationalPoint& p) {
    return static_cast<std::uint32_t>(vulkan(whole_numbers(p), n, Fault::none));
  };
  functions.index_floats = [](Level n, proofs::index::FloatBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t) {
      const RationalPoint p{proofs::points::rational(batch.u[t]), proofs::points::rational(batch.v[t])};
      out[t] = static_cast<std::uint32_t>(vulkan(whole_numbers(p), n, Fault::none));
    }
  };
  functions.max_wide_level = 30;
  functions.wide_index = [](Level n, const proofs::points::Row& row, std::span<std::uint64_t> out) {
    for (std::uint64_t t = 0; t < row.count; ++t)
      out[t] = vulkan(whole_numbers(representative(row, t, n)), n, Fault::none);
  };
  functions.wide_index_at = [](Level n, const RationalPoint& p) {
    return vulkan(whole_numbers(p), n, Fault::none);
  };
  return functions;
}

/// Figure 4's row order by counting: of the lines u+v = k/N, v = k/N and 1-u = k/N, those that lie below a point.
std::uint32_t row_order_by_lines(Level n, const proofs::points::RationalPoint& p) {
  using spec::Rational;
  const std::uint32_t N = std::uint32_t{1} << n;
  const auto lines = [N](const Rational& q, std::uint32_t most) {
    std::uint32_t low = 0;  // 0/N is no more than q
    for (std::uint32_t high = most + 1; high - low > 1;) {
      const std::uint32_t middle = (low + high) / 2;
      (Rational(middle) <= q * Rational(N) ? low : high) = middle;
    }
    return low;
  };
  const std::uint32_t row = lines(p.u + p.v, N - 1);
  return row * row + lines(p.v, row) + lines(Rational(1) - p.u, N - 1) - (N - 1 - row);
}

/// The same with row order.
proofs::index::Functions functions_of_rows() {
  proofs::index::Functions f = functions_of_the_curve();
  f.row_index_at = row_order_by_lines;
  f.row_index_floats = [](Level n, proofs::index::FloatBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] =
          row_order_by_lines(n, {proofs::points::rational(batch.u[t]), proofs::points::rational(batch.v[t])});
  };
  return f;
}

/// Right on every point, whatever its statements say.
class IndexProof : public proofs::index::IndexSubject, public Provable {
 public:
  IndexProof(const char* name, Statements statements)
      : IndexSubject(name, "by another hand", functions_of_rows()), statements_(std::move(statements)) {}
  Statements statements() const override { return statements_; }

 private:
  const Statements statements_;
};

/// A map and the paper's two sequences of it, by recursion.
class PaperTree {
 public:
  explicit PaperTree(proofs::tree::Map map) : map_(std::move(map)) {}
  proofs::tree::Bytes decode() const { return map_.packed; }
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const {
    for (std::size_t t = 0; t < index.size(); ++t) state[t] = static_cast<std::uint8_t>(state_at(index[t]));
  }
  proofs::tree::Bytes bytes() const {
    std::vector<unsigned> nodes, values;
    write(0, map_.level, nodes, values);
    proofs::tree::Bytes all = packed(nodes, 1);
    const proofs::tree::Bytes leaves = packed(values, width());
    all.insert(all.end(), leaves.begin(), leaves.end());
    return all;
  }

 private:
  unsigned width() const { return map_.format == proofs::tree::Format::two_state ? 1 : 2; }
  unsigned state_at(std::size_t k) const {
    return static_cast<unsigned>(map_.packed[k * width() / 8]) >> k * width() % 8 & ((1u << width()) - 1);
  }
  /// The subtree of 4^level states from `first` on: a leaf where they are all one.
  void write(std::size_t first, Level level, std::vector<unsigned>& nodes,
             std::vector<unsigned>& values) const {
    const std::size_t count = std::size_t{1} << 2 * level;
    bool uniform = true;
    for (std::size_t k = 1; k < count; ++k) uniform = uniform && state_at(first + k) == state_at(first);
    nodes.push_back(uniform ? 0 : 1);
    if (uniform) return values.push_back(state_at(first));
    for (std::size_t child = 0; child < 4; ++child)
      write(first + child * count / 4, level - 1, nodes, values);
  }
  static proofs::tree::Bytes packed(const std::vector<unsigned>& fields, unsigned width) {
    proofs::tree::Bytes bytes((fields.size() * width + 7) / 8, 0);
    for (std::size_t k = 0; k < fields.size(); ++k)
      bytes[k * width / 8] = static_cast<std::uint8_t>(bytes[k * width / 8] | fields[k] << k * width % 8);
    return bytes;
  }

  proofs::tree::Map map_;
};

proofs::tree::Functions functions_of_paper_trees() {
  using proofs::tree::Code;
  proofs::tree::Functions functions;
  functions.encode = [](const proofs::tree::Map& map) {
    return proofs::tree::coded(map.level, map.format, PaperTree(map));
  };
  const auto tree = [](const Code& code) -> const PaperTree& {
    return proofs::tree::form_of<PaperTree>(code);
  };
  functions.decode = [tree](const Code& code) { return tree(code).decode(); };
  functions.lookup = [tree](const Code& code, auto index, auto state) { tree(code).lookup(index, state); };
  functions.bytes = [tree](const Code& code) { return tree(code).bytes(); };
  functions.writes_paper = true;
  return functions;
}

/// Right on every map, whatever its statements say.
class TreeProof : public proofs::tree::TreeSubject, public Provable {
 public:
  TreeProof(const char* name, Statements statements)
      : proofs::tree::TreeSubject(name, "by another hand", functions_of_paper_trees()),
        statements_(std::move(statements)) {}
  Statements statements() const override { return statements_; }

 private:
  const Statements statements_;
};

/// The published code by another hand, whose set the law is about, whatever its statements say.
class PublishedProof : public proofs::index::IndexSubject, public Provable {
 public:
  PublishedProof(const char* name, Statements statements)
      : IndexSubject(name, "by another hand", functions()), statements_(std::move(statements)) {}
  Statements statements() const override { return statements_; }

 private:
  static proofs::index::Functions functions() {
    proofs::index::Functions f = functions_of_the_curve();
    f.arithmetic = proofs::index::Arithmetic::binary32;
    f.index_floats = [](Level n, proofs::index::FloatBatch batch, std::span<std::uint32_t> out) {
      for (std::size_t t = 0; t < out.size(); ++t)
        out[t] = proofs::index::published(n, batch.u[t], batch.v[t]);
    };
    return f;
  }
  const Statements statements_;
};

constexpr const char* published_law = "index.published_differs_where";

InsideFault proof(const char* law, const char* name, const char* wrong, Statements statements) {
  proofs::SubjectPtr subject;
  if (std::string(law) == published_law)
    subject = std::make_shared<PublishedProof>(name, std::move(statements));
  else if (std::string(law).starts_with("tree"))
    subject = std::make_shared<TreeProof>(name, std::move(statements));
  else
    subject = std::make_shared<IndexProof>(name, std::move(statements));
  return {law, name, wrong, std::move(subject), {0, 0}};
}

struct Alteration {
  const char *law, *name, *wrong, *statement, *before, *after;
};

constexpr Alteration alterations[] = {
    {"index.all_levels", "w_tie_in_upright", "one of upright's comparisons of w with 1/2 takes the tie",
     "transition_upright", "(< (to_real M) (* 2.0 w))", "(<= (to_real M) (* 2.0 w))"},
    {"index.all_levels", "sign_of_w_in_middle", "out of a middle triangle, u' has w with the other sign",
     "transition_middle", "(/ (- (- u v) w) 2.0)", "(/ (+ (- u v) w) 2.0)"},
    {"index.all_levels", "above_forgotten", "the XOR of the bits above is forgotten", "transition_upright",
     "(define-fun next_above () Bool (xor above (and (xor bu bv) b0)))",
     "(define-fun next_above () Bool (and (xor bu bv) b0))"},
    {"index.all_levels", "beyond_hypotenuse", "the opening is said of points beyond the hypotenuse as well",
     "opening", "(assert (<= (+ u v) (to_real M)))\n", ""},
    {"index.all_levels", "middle_is_empty", "what is supposed of a middle triangle cannot be",
     "witness_transition_middle", "(< 0.0 v) (< 0.0 w)", "(< 0.0 v) (< w 0.0)"},
    {"index.wide_is_vulkan", "level_17", "the agreement is said of level 17 as well", "agreement",
     "(assert (bvule N (_ bv65536 32)))", "(assert (bvule N (_ bv131072 32)))"},
    {"index.wide_is_vulkan", "shift_of_3", "the prefix XOR shifts by 3 in place of 4", "prefix_xor_32",
     "(bvlshr part_a (_ bv4 32))", "(bvlshr part_a (_ bv3 32))"},
    {"index.wide_is_vulkan", "mask_of_15", "a mask of the spreading is that of 15", "spread_64",
     "(bvshl (_ bv1 64) (_ bv16 64))", "(bvshl (_ bv1 64) (_ bv15 64))"},
    {"index.impl_wide_is_wide", "u_without_bound", "iu may be any word", "square", "(assert (bvule iu N))\n",
     ""},
    {"index.impl_wide_is_wide", "mask_lacks_a_bit", "a mask of the spreading lacks its lowest bit", "bits",
     "(_ bv71777214294589695 64)", "(_ bv71777214294589694 64)"},
    {"index.impl_wide_is_wide", "iw_of_any_row", "iw has nothing to do with the row", "bits",
     "(assert (= (bvand iw low) (bvand (bvnot row) low)))\n", ""},
    {"index.floats", "sum_of_1_is_below", "where uf + vf is 1, it is taken to be below", "lanes_carry",
     "(fp.geq", "(fp.gt"},
    {"index.floats", "whole_part_to_nearest", "the whole part is the nearest whole number", "scalar_parts",
     "((_ fp.to_sbv 32) RTZ", "((_ fp.to_sbv 32) RNE"},
    {"index.floats", "level_31", "whole parts are said of level 31 as well, which signed words do not hold",
     "lanes_parts", "(assert (bvule n (_ bv30 8)))", "(assert (bvule n (_ bv31 8)))"},
    {"index.floats", "rest_without_bound", "what is left of uN may be any number", "reference_32",
     "(assert (bvult uf (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))))\n", ""},
    {"index.floats", "v_without_bound", "iv may be any word", "lanes_square", "(assert (bvule iv N))\n", ""},
    {"index.floats", "not_vacuous_of_nothing", "the witness of the carry is sought where there is none",
     "witness_carry", "(assert (bvult uf_bits (_ bv1065353216 32)))", "(assert (bvult uf_bits (_ bv0 32)))"},
    {"index.row_floats", "none_is_more", "0 counts as more than 0", "scalar_more", "(fp.gt", "(fp.geq"},
    {"index.row_floats", "u_beyond_1", "u may be a hair above 1", "lanes_rows",
     "(assert (not (and (= iu N) beyond)))\n", ""},
    {"index.row_floats", "rest_of_u_without_bound", "what is left of uN may be any number", "floor_of_rest",
     "(assert (bvult uf (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))))\n", ""},
    {"index.row_floats", "not_vacuous_of_nothing", "the witness of the floors is sought where there is none",
     "witness_floors", "(assert (bvule iu N))", "(assert (bvult N iu))"},
    {published_law, "hair_of_24_bits", "the set begins at 1 - 2^-24", "square", "(_ bv124 184)",
     "(_ bv125 184)"},
    {published_law, "halves_of_last_square", "the halves differ in the squares at the hypotenuse as well",
     "halves", "(bvult (bvadd iu iv) low)", "(bvule (bvadd iu iv) low)"},
    {published_law, "whole_part_up", "the whole part is rounded up", "parts", "((_ fp.to_ubv 32) RTZ",
     "((_ fp.to_ubv 32) RTP"},
    {"tree.all_levels", "three_children", "bitscan counts three subtrees below an internal node", "skip_node",
     "(- (+ c 4) 1)", "(- (+ c 3) 1)"},
    {"tree.all_levels", "children_exchanged", "Algorithm 2 has the second child above the first", "emit_node",
     "(stacked (child0 T) (stacked (child1 T)", "(stacked (child1 T) (stacked (child0 T)"},
    {"tree.all_levels", "node_counts_twice", "an internal node counts as two", "sizes_node",
     "(+ 1 (nodes (child0 T))", "(+ 2 (nodes (child0 T))"},
    {"tree.all_levels", "one_quarter_not_supposed", "nothing is supposed of the last quarter",
     "canonical_node_node", "(assert (alike (part3 T) (part3 S)))\n", ""},
};

}  // namespace

std::vector<InsideFault> inside_right_of_provers() {
  return {proof("index.all_levels", "shipped", "", shipped("index/all_levels")),
          proof("index.wide_is_vulkan", "shipped", "", shipped("index/wide_is_vulkan")),
          proof("index.impl_wide_is_wide", "shipped", "", shipped("index/impl_wide_is_wide")),
          proof("index.floats", "shipped", "", shipped("index/floats")),
          proof("index.row_floats", "shipped", "", rows()),
          proof(published_law, "shipped", "", shipped("index/published_differs_where")),
          proof("tree.all_levels", "shipped", "", shipped("tree/all_levels"))};
}

std::vector<InsideFault> inside_faults_of_provers() {
  std::vector<InsideFault> all;
  for (const Alteration& a : alterations) {
    std::string folder = a.law;
    std::replace(folder.begin(), folder.end(), '.', '/');
    all.push_back(proof(a.law, a.name, a.wrong, altered(folder, a.statement, a.before, a.after)));
  }
  return all;
}

}  // namespace mmverify::tests::foreign
