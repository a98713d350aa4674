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
      {{one_of("form", key, {"flat", "paper", "ours", "sdsl"}), "form"},
       [](const FormOf& f) { return to_string(f.form); }},
      {{number("bits_per_micro_triangle", about_less,
               "all memory of the form; of paper its two sequences alone"),
        "bits a micro-triangle", "", digits(4)},
       [](const FormOf& f) { return f.figures.bits; }},
      {{time("ns_per_lookup", "ns a lookup; independent random ones over all maps"), "a lookup", "ns",
        digits(1)},
       [](const FormOf& f) { return f.figures.ns; }},
      {{time("least_ns_per_lookup", "ns a lookup, of the fastest round").if_any()},
       [](const FormOf& f) { return f.figures.least_ns; }},
      {{time("most_ns_per_lookup", "ns a lookup, of the slowest round").if_any()},
       [](const FormOf& f) { return f.figures.most_ns; }},
      {{time("ns_per_chained_lookup", "ns a lookup that waits for the one before"), "a lookup in a chain",
        "ns", digits(1)},
       [](const FormOf& f) { return f.figures.chained_ns; }},
      {{number("cache_lines", about_less, "lines of 64 bytes that a lookup reads, by a model, mean"),
        "cache lines", "", digits(1)},
       [](const FormOf& f) { return f.figures.lines; }},
  };
}

}  // namespace

Result tree_tables(const std::vector<TreeFigures>& figures, const TreeBenchOptions& options) {
  const std::string stream = "the paper's stream, mean", lookups = "time a lookup", encode = "encode a map",
                    decode = "decode a map";
  const Print three{.digits = 3, .type = 'g'}, ns{.digits = 0}, times{.digits = 1};
  const Fields<F> fields{
      {{.key = one_of("states", key, {2, 4}), .heading = "states", .leads = true},
       [](const F& f) { return f.bits == 1 ? 2u : 4u; }},
      {{.key = level(12), .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{positive("maps", same), "maps"}, [](const F& f) { return std::uint64_t{f.maps}; }},
      {{real("nodes", same, {1}, "of the paper's tree, mean"), "nodes", "", digits(0), stream},
       [](const F& f) { return f.nodes; }},
      {{number("paper_bits_read", about_less, "of the paper's tree by a lookup, mean"), "bits read", "",
        digits(0), stream},
       [](const F& f) { return f.bits_read; }},
      within<F, FormOf>({.key = list("forms", "", {4, 4}), .heading = "forms", .within = RowLayout::beside},
                        form_fields(), forms_of),
      {{ratio("ratio_paper_to_ours", speed_more,
              "of ns a lookup: the median of the rounds' ratios, as are the next two"),
        "paper / ours", "", three, lookups},
       [](const F& f) { return f.paper_over_ours; }},
      {{ratio("ratio_sdsl_to_ours", speed_more), "sdsl / ours", "", three, lookups},
       [](const F& f) { return f.sdsl_over_ours; }},
      {{ratio("ratio_ours_to_flat", speed_less), "ours / flat", "", three, lookups},
       [](const F& f) { return f.ours_over_flat; }},
      {{ratio("memory_ours_to_paper", about_less, "of bits"), "ours / paper", "", digits(3), "memory"},
       [](const F& f) { return f.memory_over_paper; }},
      {{ratio("ratio_encode_obvious_to_ours", speed_more, "of encode_ns"), "obvious / ours", "", times,
        encode},
       [](const F& f) { return f.obvious_encode / f.encode_tree; }},
      {{ratio("ratio_decode_obvious_to_ours", speed_more, "of decode_ns"), "obvious / ours", "", times,
        decode},
       [](const F& f) { return f.obvious_decode / f.decode_tree; }},
      {{"", "obvious / stream", "", times, encode},
       [](const F& f) { return f.obvious_encode / f.encode_stream; }},
      {{"", "obvious / stream", "", times, decode},
       [](const F& f) { return f.obvious_decode / f.decode_stream; }},
      note<F>(object("encode_ns", left_out, "ns a map")),
      note<F>(object("decode_ns", left_out, "ns a map")),
      {{time("encode_ns.obvious", "the recursion over the paper's stream", no_rule), "obvious", "ns", ns,
        encode},
       [](const F& f) { return f.obvious_encode; }},
      {{time("encode_ns.stream", "the same bits by impl/tree_stream", no_rule), "stream", "ns", ns, encode},
       [](const F& f) { return f.encode_stream; }},
      {{time("encode_ns.ours", "the form of impl/tree", no_rule), "ours", "ns", ns, encode},
       [](const F& f) { return f.encode_tree; }},
      {{time("decode_ns.obvious", "the recursion over the paper's stream", no_rule), "obvious", "ns", ns,
        decode},
       [](const F& f) { return f.obvious_decode; }},
      {{time("decode_ns.stream", "the same bits by impl/tree_stream", no_rule), "stream", "ns", ns, decode},
       [](const F& f) { return f.decode_stream; }},
      {{time("decode_ns.ours", "the form of impl/tree", no_rule), "ours", "ns", ns, decode},
       [](const F& f) { return f.decode_tree; }},
  };
  return {.topic = "tree",
          .description = "mmverify bench tree: size against time of the forms of a map",
          .settings = {{seed_of_all(), options.seed},
                       {positive("samples", setting, "lookups a level and format"), options.lookups},
                       {one_of("maps", setting, {"generated", "textures"}, "textures: those of --textures"),
                        options.textures.empty() ? "generated" : "textures"}},
          .about =
              "Random lookups over all maps of a level, one thread. flat: the array. paper: the two bit "
              "sequences, Algorithm 3. ours: impl/tree.\nsdsl: the tree in level order, bit_vector and "
              "rank_support_v5. Cache lines are those of a model. Ratios are of this one run:\nof times a "
              "lookup, of memory to the paper's sequences; obvious: whole maps by the recursion over the "
              "paper's stream",
          .tables = {table_of<F>({.key = "rows", .row = "one level and format"}, fields, figures)},
          .drawn = tree_picture(figures)};
}

}  // namespace mmverify::bench
