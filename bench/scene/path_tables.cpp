#include "bench/scene/path_tables.hpp"

#include <algorithm>

namespace mmverify::bench {
namespace {

Fields<render::Seen> camera_fields() {
  using S = render::Seen;
  return {
      {{.key = "camera", .heading = "camera", .leads = true}, [](const S& s) { return s.number; }},
      {{"tries", "tries"}, [](const S& s) { return std::uint64_t{s.tries}; }},
      {{"rays", "primary rays"}, [](const S& s) { return s.frame.counts.rays; }},
      {{"shadow_rays", "shadow rays"}, [](const S& s) { return s.frame.counts.shadow_rays; }},
      {{"met", "met a map"}, [](const S& s) { return s.frame.counts.met; }},
      {{"any_hit", "any-hit"}, [](const S& s) { return s.frame.counts.shader; }},
  };
}

Fields<render::PathRow> row_fields() {
  using R = render::PathRow;
  return {
      {{.key = "method", .heading = "method", .leads = true},
       [](const R& r) { return std::string(name_of(r.method)); }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const R& r) { return r.level ? Value(std::uint64_t{*r.level}) : Value(); }},
      {{"frames", "frames"}, [](const R& r) { return r.frames; }},
      {{"pixels", "pixels"}, [](const R& r) { return r.pixels; }},
      {{"met", "met a map"}, [](const R& r) { return r.counts.met; }},
      {{"ignored", "ignored"}, [](const R& r) { return r.counts.ignored; }},
      {{"opaque", "opaque"}, [](const R& r) { return r.counts.opaque; }},
      {{"any_hit", "any-hit"}, [](const R& r) { return r.counts.shader; }},
      {{"differing", "differing"}, [](const R& r) { return r.differing; }},
  };
}

}  // namespace

Result path_tables(const PathFigures& figures) {
  using F = PathFigures;
  const auto& rows = figures.path->rows;
  const bool refuted =
      std::any_of(rows.begin(), rows.end(), [](const render::PathRow& r) { return r.differing != 0; });
  const std::string verdict = refuted ? "refuted" : "checked";
  const Fields<F> whole{
      {{.key = "file"}, [](const F& f) { return f.file; }},
      {{.key = "law"}, [](const F&) { return std::string("traverse.same_image"); }},
      {{.key = "verdict"}, [&verdict](const F&) { return verdict; }},
      {{"tested", "triangles with micromaps"}, [](const F& f) { return f.tested; }},
      {{"tested_placed", "of these, placed"}, [](const F& f) { return f.tested_placed; }},
      {{"frames", "frames held against the texture's"},
       [](const F& f) {
         std::uint64_t sum = 0;
         for (const auto& r : f.path->rows) sum += r.frames;
         return sum;
       }},
      {{"pixels", "pixels"},
       [](const F& f) {
         std::uint64_t sum = 0;
         for (const auto& r : f.path->rows) sum += r.pixels;
         return sum;
       }},
      {{"differing", "of these, differing"},
       [](const F& f) {
         std::uint64_t sum = 0;
         for (const auto& r : f.path->rows) sum += r.differing;
         return sum;
       }},
  };
  return {.topic = "render_path",
          .settings = {{"embree", figures.embree},
                       {"width", std::uint64_t{figures.width}},
                       {"height", std::uint64_t{figures.height}},
                       {"cameras", std::uint64_t{figures.path->cameras.size()}},
                       {"seed", figures.seed},
                       {"shadows", std::string(figures.shadows ? "yes" : "no")},
                       {"threads", figures.threads}},
          .about = verdict + " traverse.same_image on " + figures.file +
                   ": by each form of its micromaps, rays of cameras on a random path meet the triangles, at "
                   "the t, and the light that they meet by the texture alone; met a map: rays, shadow rays "
                   "among them, with a candidate on a triangle that gets a micromap; any-hit: candidates "
                   "that the texture decides; tries: places until a ray of the camera met a map",
          .tables = {table_of<F>({.form = Form::members}, whole, {figures}),
                     table_of<render::Seen>({.key = "cameras"}, camera_fields(), figures.path->cameras),
                     table_of<render::PathRow>({.key = "rows"}, row_fields(), rows)}};
}

}  // namespace mmverify::bench
