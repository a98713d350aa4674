#include "bench/scene/render_tables.hpp"

namespace mmverify::bench {
namespace {

using render::MethodFigures;

double a_ray(const MethodFigures& m, std::uint64_t count) {
  const std::uint64_t rays = m.counts.rays + m.counts.shadow_rays;
  return rays == 0 ? 0 : static_cast<double>(count) / static_cast<double>(rays);
}

Fields<MethodFigures> method_fields() {
  using M = MethodFigures;
  return {
      {{.key = "method", .heading = "method", .leads = true},
       [](const M& m) { return std::string(name_of(m.method)); }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const M& m) { return m.level ? Value(std::uint64_t{*m.level}) : Value(); }},
      {{"candidates", "candidates"}, [](const M& m) { return m.counts.candidates; }},
      {{"ignored", "ignored"}, [](const M& m) { return m.counts.ignored; }},
      {{"opaque", "opaque"}, [](const M& m) { return m.counts.opaque; }},
      {{"any_hit", "any-hit"}, [](const M& m) { return m.counts.shader; }},
      {{"any_hit_a_ray", "a ray", "", {.digits = 3}}, [](const M& m) { return a_ray(m, m.counts.shader); }},
      {{"known", "known", "", {2, 'f', per_cent, "%"}}, [](const M& m) { return m.counts.known(); }},
      {{"predicted", "predicted", "", {2, 'f', per_cent, "%"}},
       [](const M& m) { return m.predicted ? Value(*m.predicted) : Value(); }},
      {{"even", "even", "", {2, 'f', per_cent, "%"}},
       [](const M& m) { return m.even ? Value(*m.even) : Value(); }},
      {{"texels", "texels"}, [](const M& m) { return m.counts.fetches; }},
      {{"bytes", "bytes"}, [](const M& m) { return m.bytes; }},
      {{"differing", "differing"}, [](const M& m) { return m.differing; }},
      {{"ms", "frame", "ms", {.digits = 1}}, [](const M& m) { return 1e3 * m.seconds; }},
      {{"cpu_ms", "CPU", "ms", {.digits = 1}}, [](const M& m) { return 1e3 * m.cpu_seconds; }},
      {{"times_texture", "x texture"}, [](const M& m) { return m.times_texture; }},
  };
}

Fields<render::BlendFigures> blend_fields() {
  using B = render::BlendFigures;
  return {
      {{.key = "method", .heading = "method", .leads = true},
       [](const B& b) { return std::string(name_of(b.method)); }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const B& b) { return b.level ? Value(std::uint64_t{*b.level}) : Value(); }},
      {{.key = "by", .heading = "blended by", .leads = true},
       [](const B& b) { return std::string(b.by == render::BlendedBy::shader ? "shader" : "fixed"); }},
      {{"candidates", "candidates"}, [](const B& b) { return b.counts.candidates; }},
      {{"ignored", "ignored"}, [](const B& b) { return b.counts.ignored; }},
      {{"fixed", "fixed"}, [](const B& b) { return b.counts.opaque; }},
      {{"any_hit", "any-hit"}, [](const B& b) { return b.counts.shader; }},
      {{"saved", "saved", "", {2, 'f', per_cent, "%"}}, [](const B& b) { return b.saved; }},
      {{"texels", "texels"}, [](const B& b) { return b.counts.fetches; }},
      {{"differing", "differing"}, [](const B& b) { return b.differing; }},
      {{"spoiled", "as met"}, [](const B& b) { return b.spoiled; }},
      {{"cpu_ms", "CPU", "ms", {.digits = 1}}, [](const B& b) { return 1e3 * b.cpu_seconds; }},
      {{"times_texture", "x texture"}, [](const B& b) { return b.times_texture; }},
  };
}

}  // namespace

Result render_tables(const RenderFigures& figures) {
  using F = RenderFigures;
  using P = RenderPictureFile;
  const Fields<F> whole{
      {{.key = "file"}, [](const F& f) { return f.file; }},
      {{"triangles", "triangles"}, [](const F& f) { return f.triangles; }},
      {{"placed", "placed"}, [](const F& f) { return f.placed; }},
      {{"tested", "with micromaps"}, [](const F& f) { return f.tested; }},
      {{"tested_placed", "of these, placed"}, [](const F& f) { return f.tested_placed; }},
      {{"unplanned", "tested, and left out of the plan"}, [](const F& f) { return f.unplanned; }},
      {{"rays", "primary rays"}, [](const F& f) { return f.methods.front().counts.rays; }},
      {{"shadow_rays", "shadow rays"}, [](const F& f) { return f.methods.front().counts.shadow_rays; }},
  };
  const Fields<P> pictures{
      {{.key = "shows", .heading = "picture", .leads = true}, [](const P& p) { return p.shows; }},
      {{"file", "file"}, [](const P& p) { return p.file; }},
  };
  Result result{
      .topic = "render",
      .settings = {{"embree", figures.embree},
                   {"width", std::uint64_t{figures.width}},
                   {"height", std::uint64_t{figures.height}},
                   {"camera", figures.camera},
                   {"seed", figures.seed},
                   {"threads", figures.threads}},
      .about = figures.file +
               ": any-hit: candidates that the texture decides; known: the share of candidates on triangles "
               "with micromaps that a map decides; predicted: the same by the maps' area; even: the same, "
               "met by rays from everywhere; bytes: of maps, records and indices, of texture its texels; "
               "differing: pixels whose rays met another triangle, t or light than with the texture alone",
      .tables = {table_of<F>({.form = Form::members}, whole, {figures}),
                 table_of<MethodFigures>({.key = "rows"}, method_fields(), figures.methods)}};
  if (!figures.blends.empty()) {
    result.settings.emplace_back("blend", figures.operation);
    result.tables.push_back(table_of<render::BlendFigures>(
        {.key = "blends",
         .caption = "hits on surfaces blend by " + figures.operation +
                    ", and the ray goes on; fixed: candidates that a fixed function blends; saved: of the "
                    "any-hit calls of the texture alone; differing: pixels whose payload is not the "
                    "texture's; as met: pixels that would differ, were hits blended as they are met"},
        blend_fields(), figures.blends));
  }
  if (!figures.colours.empty()) {
    result.settings.emplace_back("colours", figures.colours);
    result.settings.emplace_back("colour_level", figures.colour_level);
    result.settings.emplace_back("colour_bytes", figures.colour_bytes);
  }
  if (!figures.pictures.empty())
    result.tables.push_back(table_of<P>({.key = "pictures"}, pictures, figures.pictures));
  return result;
}

}  // namespace mmverify::bench
