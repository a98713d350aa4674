#include "bench/scene/path_tables.hpp"

#include <algorithm>

#include "bench/scene/render_words.hpp"

namespace mmverify::bench {
namespace {

Fields<render::CameraView> camera_fields() {
  using S = render::CameraView;
  return {
      {{.key = count("camera", key, "its number on the path, from 1"), .heading = "camera", .leads = true},
       [](const S& s) { return s.number; }},
      {{count("tries", same, "places that were tried until a ray met a triangle that gets a micromap"),
        "tries"},
       [](const S& s) { return std::uint64_t{s.tries}; }},
      {{count("rays", same, "primary, one a pixel"), "primary rays"},
       [](const S& s) { return s.frame.counts.rays; }},
      {{count("shadow_rays", same, "one where a primary ray hits"), "shadow rays"},
       [](const S& s) { return s.frame.counts.shadow_rays; }},
      {{count("ambient_rays", same, "of ambient occlusion; not there without any").if_any(), "ambient rays"},
       [](const S& s) {
         const std::uint64_t rays = s.frame.counts.ambient_rays;
         return rays == 0 ? Value() : Value(rays);
       }},
      {{count("met", same, "rays of all kinds with a candidate on a triangle that gets a micromap"),
        "met a map"},
       [](const S& s) { return s.frame.counts.met; }},
      {{count("any_hit", same, "any-hit calls of the texture alone"), "any-hit"},
       [](const S& s) { return s.frame.counts.shader; }},
  };
}

Fields<render::PathRow> row_fields() {
  using R = render::PathRow;
  return {
      {{.key = one_of_range("method", key, all_methods(), "how opacity is asked for"),
        .heading = "method",
        .leads = true},
       [](const R& r) { return std::string(name_of(r.method)); }},
      {{.key = level(12, key, without_levels).if_any(), .heading = "level", .leads = true},
       [](const R& r) { return r.level ? Value(std::uint64_t{*r.level}) : Value(); }},
      {{count("frames", same, "one a camera"), "frames"}, [](const R& r) { return r.frames; }},
      {{count("pixels", same, "of these frames"), "pixels"}, [](const R& r) { return r.pixels; }},
      {{count("met", same, "rays of all cameras with a candidate on a triangle that gets a micromap"),
        "met a map"},
       [](const R& r) { return r.counts.met; }},
      {{count("ignored", more, "candidates that a map says are transparent"), "ignored"},
       [](const R& r) { return r.counts.ignored; }},
      {{count("opaque", more, "that a map says are opaque"), "opaque"},
       [](const R& r) { return r.counts.opaque; }},
      {{count("any_hit", less, "the rest: any-hit calls, decided by the texture"), "any-hit"},
       [](const R& r) { return r.counts.shader; }},
      {{count("differing", less, "pixels that are not the texture's"), "differing"},
       [](const R& r) { return r.differing; }},
  };
}

/// A figure over the cameras: its mean, extremes and standard deviation.
struct SpreadRow {
  std::string method;
  std::optional<unsigned> level;
  render::Spread calls, times;
};

std::vector<SpreadRow> spreads(const render::Path& path) {
  std::vector<double> calls;
  for (const render::CameraView& seen : path.cameras) calls.push_back(calls_a_ray(seen.frame.counts));
  std::vector<SpreadRow> rows{{"texture", {}, render::spread_of(calls), {1, 1, 1, 0}}};
  for (const render::PathRow& row : path.rows)
    rows.push_back({std::string(name_of(row.method)), row.level, render::spread_of(row.calls_a_ray),
                    render::spread_of(row.times_texture)});
  return rows;
}

/// The columns of one spread.
void add_spread(Fields<SpreadRow>& fields, const char* name, const char* group, Rule rule,
                int after_the_point, render::Spread SpreadRow::*its) {
  const auto add = [&](const char* which, double render::Spread::*figure, const char* says) {
    fields.push_back({{.key = number(std::string(name) + "_" + which, rule, says),
                       .heading = which,
                       .print = digits(after_the_point),
                       .group = group},
                      [its, figure](const SpreadRow& row) { return row.*its.*figure; }});
  };
  add("mean", &render::Spread::mean, "over the cameras, each of the same weight");
  add("least", &render::Spread::least, "of a camera");
  add("most", &render::Spread::most, "of a camera");
  add("deviation", &render::Spread::deviation, "the standard deviation over the cameras");
}

Fields<SpreadRow> spread_fields() {
  Fields<SpreadRow> fields{
      {{.key = one_of_range("method", key, all_methods(), "how opacity is asked for"),
        .heading = "method",
        .leads = true},
       [](const SpreadRow& r) { return r.method; }},
      {{.key = level(12, key, without_levels).if_any(), .heading = "level", .leads = true},
       [](const SpreadRow& r) { return r.level ? Value(std::uint64_t{*r.level}) : Value(); }},
  };
  add_spread(fields, "any_hit_a_ray", "any-hit calls a ray", left_out, 3, &SpreadRow::calls);
  add_spread(fields, "times_texture", "x texture", left_out, 2, &SpreadRow::times);
  return fields;
}

}  // namespace

Result path_tables(const PathFigures& figures) {
  using F = PathFigures;
  const auto& rows = figures.path->rows;
  const bool refuted =
      std::any_of(rows.begin(), rows.end(), [](const render::PathRow& r) { return r.differing != 0; });
  const std::string verdict = refuted ? "refuted" : "checked";
  const Fields<F> members{
      {{.key = text("file", left_out)}, [](const F& f) { return f.file; }},
      {{.key = one_of("law", left_out, {"traverse.same_image"})},
       [](const F&) { return std::string("traverse.same_image"); }},
      {{.key = one_of("verdict", left_out, {"checked", "refuted"}, "refuted: a pixel differs")},
       [&verdict](const F&) { return verdict; }},
      {{count("tested", same, "triangles that get micromaps"), "triangles with micromaps"},
       [](const F& f) { return f.tested; }},
      {{count("tested_placed", same, "the same, as often as nodes place them"), "of these, placed"},
       [](const F& f) { return f.tested_placed; }},
      {{count("frames", more, "of all forms, held against the texture's"),
        "frames held against the texture's"},
       [](const F& f) {
         std::uint64_t sum = 0;
         for (const auto& r : f.path->rows) sum += r.frames;
         return sum;
       }},
      {{count("pixels", more, "of these frames"), "pixels"},
       [](const F& f) {
         std::uint64_t sum = 0;
         for (const auto& r : f.path->rows) sum += r.pixels;
         return sum;
       }},
      {{count("differing", less,
              "pixels whose rays met another triangle, another t or other light than with the texture alone"),
        "of these, differing"},
       [](const F& f) {
         std::uint64_t sum = 0;
         for (const auto& r : f.path->rows) sum += r.differing;
         return sum;
       }},
  };
  Result result{
      .topic = "render_path",
      .description = "mmverify render --cameras: law traverse.same_image on a scene, along a random path",
      .settings = {{text("embree", left_out, "the ray tracer and its version"), figures.embree},
                   {whole("width", setting, {1, 4096}, "pixels"), std::uint64_t{figures.width}},
                   {whole("height", setting, {1, 4096}, "pixels"), std::uint64_t{figures.height}},
                   {positive("cameras", setting, "of the path"), std::uint64_t{figures.path->cameras.size()}},
                   {count("seed", setting, "of the path"), figures.seed},
                   {one_of("shadows", setting, {"yes", "no"}, "whether shadow rays are traced"),
                    std::string(figures.shadows ? "yes" : "no")},
                   {count("threads", left_out, "worker threads; 0: as many as the machine has"),
                    figures.threads}},
      .about = verdict + " traverse.same_image on " + figures.file +
               ": by each form of its micromaps, rays of cameras on a random path meet the triangles, at the "
               "t, and the light that they meet by the texture alone; met a map: rays, shadow rays among "
               "them, with a candidate on a triangle that gets a micromap; any-hit: candidates that the "
               "texture decides; tries: places until a ray of the camera met a map",
      .tables = {table_of<F>({.form = Form::members}, members, {figures}),
                 table_of<render::CameraView>({.key = "cameras"}, camera_fields(), figures.path->cameras),
                 table_of<render::PathRow>({.key = list("rows", "", {})}, row_fields(), rows),
                 table_of<SpreadRow>({.key = list("spreads", "of figures over the cameras of the path"),
                                      .caption = "over the cameras, each of the same weight; x texture: the "
                                                 "processor time of a frame over that by the texture"},
                                     spread_fields(), spreads(*figures.path))}};
  add_ambient(result, figures.ambient);
  return result;
}

}  // namespace mmverify::bench
