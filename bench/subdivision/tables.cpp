#include "bench/subdivision/tables.hpp"

namespace mmverify::bench {

Result subdivision_tables(const std::vector<SubdivisionTimes>& times,
                          const std::vector<DisplacementSizes>& sizes,
                          const SubdivisionBenchOptions& options) {
  using T = SubdivisionTimes;
  using D = DisplacementSizes;
  const std::string of_index = "point to index", of_corners = "index to corners", bytes = "bytes";
  const Fields<T> by_scheme{
      {{.key = one_of("scheme", key,
                      {"triangle-4", "triangle-9", "hilbert", "morton", "tetrahedron", "bisection"}),
        .heading = "scheme",
        .leads = true},
       [](const T& t) { return t.scheme; }},
      {{.key = level(31), .heading = "level", .leads = true},
       [](const T& t) { return std::uint64_t{t.level}; }},
      {{time("index_ns", "ns a point, in the library"), "a point", "ns", digits(1), of_index},
       [](const T& t) { return t.index_ns; }},
      {{ratio("ratio_index", speed_more,
              "of ns a point: the specification in binary64 / the library; median of rounds"),
        "specification / library", "", digits(1), of_index},
       [](const T& t) { return t.index_ratio; }},
      {{time("corners_ns", "ns a cell, in the library"), "a cell", "ns", digits(1), of_corners},
       [](const T& t) { return t.corners_ns; }},
      {{ratio("ratio_corners", speed_more,
              "of ns a cell: the specification in binary64 / the library; median of rounds"),
        "specification / library", "", digits(1), of_corners},
       [](const T& t) { return t.corners_ratio; }},
  };
  const Fields<D> by_field{
      {{.key = one_of("field", key, {"terrain", "bumps", "plain"}), .heading = "height field", .leads = true},
       [](const D& d) { return d.field; }},
      {{.key = one_of("bits", key, {8, 11}, "bits of the least code, and of the greatest"),
        .heading = "bits",
        .leads = true},
       [](const D& d) { return std::uint64_t{d.bits}; }},
      {{.key = level(6), .heading = "level", .leads = true},
       [](const D& d) { return std::uint64_t{d.level}; }},
      {{count("flat_bytes", same, "bytes of the pairs one after another"), "flat", "", {}, bytes},
       [](const D& d) { return d.flat; }},
      {{count("tree_bytes", less, "bytes of the tree with a leaf for four siblings of one pair"),
        "merged tree",
        "",
        {},
        bytes},
       [](const D& d) { return d.tree; }},
      {{count("narrowing_bytes", less, "bytes of the tree of ranges within ranges"),
        "narrowing tree",
        "",
        {},
        bytes},
       [](const D& d) { return d.narrowing; }},
  };
  return {
      .topic = "subdivision",
      .description =
          "mmverify bench subdivision: cells of shapes that are cut again and again, and trees of "
          "displacements",
      .settings = {{seed_of_all(), options.seed}},
      .about =
          "Random points and their cells, one thread; the specification goes child by child, in binary64.\n"
          "Displacements: the least and the greatest in each micro-triangle; each tree gives its map back",
      .tables = {table_of<T>({.key = "rows", .row = "one scheme and level"}, by_scheme, times),
                 table_of<D>({.key = "displacements",
                              .row = "one height field, bits and level",
                              .caption = "Maps of displacements"},
                             by_field, sizes)}};
}

}  // namespace mmverify::bench
