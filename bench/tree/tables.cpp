#include "bench/tree/tables.hpp"

#include <string>

namespace mmverify::bench {
namespace {

using F = TreeFigures;

constexpr TreeForm forms[] = {TreeForm::flat, TreeForm::paper, TreeForm::ours, TreeForm::sdsl};

struct FormOf {
  TreeForm form;
  TreeFormFigures figures;
};

std::vector<FormOf> forms_of(const F& f) {
  std::vector<FormOf> all;
  for (const TreeForm form : forms) all.push_back({form, f.form(form)});
  return all;
}

Fields<FormOf> form_fields() {
  return {
      {{"form", "form"}, [](const FormOf& f) { return to_string(f.form); }},
      {{"bits_per_micro_triangle", "bits a micro-triangle", "", {.digits = 4}},
       [](const FormOf& f) { return f.figures.bits; }},
      {{"ns_per_lookup", "a lookup", "ns", {.digits = 1}}, [](const FormOf& f) { return f.figures.ns; }},
      {{"ns_per_chained_lookup", "a lookup in a chain", "ns", {.digits = 1}},
       [](const FormOf& f) { return f.figures.chained_ns; }},
      {{"cache_lines", "cache lines", "", {.digits = 1}}, [](const FormOf& f) { return f.figures.lines; }},
  };
}

}  // namespace

Result tree_tables(const std::vector<TreeFigures>& figures, const TreeBenchOptions& options) {
  const std::string stream = "the paper's stream, mean", lookups = "time a lookup", encode = "encode a map",
                    decode = "decode a map";
  const Print ratio{.digits = 3, .type = 'g'}, ns{.digits = 0}, times{.digits = 1};
  const Fields<F> fields{
      {{.key = "states", .heading = "states", .leads = true},
       [](const F& f) { return f.bits == 1 ? 2u : 4u; }},
      {{.key = "level", .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{"maps", "maps"}, [](const F& f) { return std::uint64_t{f.maps}; }},
      {{"nodes", "nodes", "", {.digits = 0}, stream}, [](const F& f) { return f.nodes; }},
      {{"paper_bits_read", "bits read", "", {.digits = 0}, stream}, [](const F& f) { return f.bits_read; }},
      within<F, FormOf>({.key = "forms", .heading = "forms", .within = Within::beside}, form_fields(),
                        forms_of),
      {{"ratio_paper_to_ours", "paper / ours", "", ratio, lookups},
       [](const F& f) { return f.paper_over_ours; }},
      {{"ratio_sdsl_to_ours", "sdsl / ours", "", ratio, lookups},
       [](const F& f) { return f.sdsl_over_ours; }},
      {{"ratio_ours_to_flat", "ours / flat", "", ratio, lookups},
       [](const F& f) { return f.ours_over_flat; }},
      {{"memory_ours_to_paper", "ours / paper", "", {.digits = 3}, "memory"},
       [](const F& f) { return f.memory_over_paper; }},
      {{"ratio_encode_obvious_to_ours", "obvious / ours", "", times, encode},
       [](const F& f) { return f.obvious_encode / f.encode_tree; }},
      {{"ratio_decode_obvious_to_ours", "obvious / ours", "", times, decode},
       [](const F& f) { return f.obvious_decode / f.decode_tree; }},
      {{"", "obvious / stream", "", times, encode},
       [](const F& f) { return f.obvious_encode / f.encode_stream; }},
      {{"", "obvious / stream", "", times, decode},
       [](const F& f) { return f.obvious_decode / f.decode_stream; }},
      {{"encode_ns.obvious", "obvious", "ns", ns, encode}, [](const F& f) { return f.obvious_encode; }},
      {{"encode_ns.stream", "stream", "ns", ns, encode}, [](const F& f) { return f.encode_stream; }},
      {{"encode_ns.ours", "ours", "ns", ns, encode}, [](const F& f) { return f.encode_tree; }},
      {{"decode_ns.obvious", "obvious", "ns", ns, decode}, [](const F& f) { return f.obvious_decode; }},
      {{"decode_ns.stream", "stream", "ns", ns, decode}, [](const F& f) { return f.decode_stream; }},
      {{"decode_ns.ours", "ours", "ns", ns, decode}, [](const F& f) { return f.decode_tree; }},
  };
  return {.topic = "tree",
          .settings = {{"seed", options.seed},
                       {"samples", options.lookups},
                       {"maps", options.textures.empty() ? "generated" : "textures"}},
          .about =
              "Random lookups over all maps of a level, one thread. flat: the array. paper: the two bit "
              "sequences, Algorithm 3. ours: impl/tree.\nsdsl: the tree in level order, bit_vector and "
              "rank_support_v5. Cache lines are those of a model. Ratios are of this one run:\nof times a "
              "lookup, of memory to the paper's sequences; obvious: whole maps by the recursion over the "
              "paper's stream",
          .tables = {table_of<F>({.key = "rows"}, fields, figures)},
          .drawn = tree_picture(figures)};
}

}  // namespace mmverify::bench
