#include "bench/scene/render_tables.hpp"

#include <algorithm>

#include "bench/scene/render_words.hpp"

namespace mmverify::bench {
namespace {

using render::MethodFigures;

/// The columns of 2-state pictures, which are not the texture's.
void add_two_states(Fields<MethodFigures>& fields) {
  using M = MethodFigures;
  const auto after = std::find_if(fields.begin(), fields.end(),
                                  [](const auto& field) { return field.column.key.name == "differing"; });
  fields.insert(
      after + 1,
      {{{share("flip", about_less, "mean FLIP of the picture beside the texture's; only with 2 states")
             .if_any(),
         "FLIP", "", digits(4)},
        [](const M& m) { return m.flip ? Value(*m.flip) : Value(); }},
       {{count("apart", less,
               "pixels that are not those of the first form of the same maps, of which there may be none; "
               "not there "
               "of a texture and of special indices alone")
             .if_any(),
         "apart"},
        [](const M& m) { return m.apart ? Value(*m.apart) : Value(); }}});
}

Fields<MethodFigures> method_fields(bool two_states) {
  using M = MethodFigures;
  Fields<M> fields{
      {{.key = one_of_range("method", key, all_methods(), "how opacity is asked for"),
        .heading = "method",
        .leads = true},
       [](const M& m) { return std::string(name_of(m.method)); }},
      {{.key = level(12, key, without_levels).if_any(), .heading = "level", .leads = true},
       [](const M& m) { return m.level ? Value(std::uint64_t{*m.level}) : Value(); }},
      {{count("candidates", same, "hits on triangles that have a surface"), "candidates"},
       [](const M& m) { return m.counts.candidates; }},
      {{count("ignored", more, "that a map says are transparent"), "ignored"},
       [](const M& m) { return m.counts.ignored; }},
      {{count("opaque", more, "that a map says are opaque"), "opaque"},
       [](const M& m) { return m.counts.opaque; }},
      {{count("any_hit", less, "the rest: any-hit calls, decided by the texture"), "any-hit"},
       [](const M& m) { return m.counts.shader; }},
      {{number("any_hit_a_ray", about_less, "any_hit / (rays + shadow_rays + ambient_rays)"), "a ray", "",
        digits(3)},
       [](const M& m) { return calls_a_ray(m.counts); }},
      {{share("known", about_more, "(ignored + opaque) / the candidates on triangles that get micromaps"),
        "known", "", percents(2)},
       [](const M& m) { return m.counts.known(); }},
      {{share("predicted", about_more,
              "the share of the placed area where the maps call no shader; not there where special indices "
              "alone are read")
            .if_any(),
        "predicted", "", percents(2)},
       [](const M& m) { return m.predicted ? Value(*m.predicted) : Value(); }},
      {{share("even", about_more,
              "the share that lines of all directions through all of the scene met; there where predicted is")
            .if_any(),
        "even", "", percents(2)},
       [](const M& m) { return m.even ? Value(*m.even) : Value(); }},
      {{count("texels", less, "read by the any-hit calls"), "texels"},
       [](const M& m) { return m.counts.fetches; }},
      {{count("bytes", less, "of maps, records and indices; of texture those of its texels"), "bytes"},
       [](const M& m) { return m.bytes; }},
      {{count("differing", less,
              "pixels whose rays met another triangle, another t or other light than with the texture alone"),
        "differing"},
       [](const M& m) { return m.differing; }},
      {{time("ms", "ms a frame, the fastest, all threads"), "frame", "ms", digits(1)},
       [](const M& m) { return 1e3 * m.seconds; }},
      {{time("cpu_ms", "ms of processor time a frame, the least"), "CPU", "ms", digits(1)},
       [](const M& m) { return 1e3 * m.cpu_seconds; }},
      {{ratio("times_texture", speed_less, "cpu_ms / that of texture"), "x texture"},
       [](const M& m) { return m.times_texture; }},
  };
  if (two_states) add_two_states(fields);
  return fields;
}

Fields<render::BlendFigures> blend_fields() {
  using B = render::BlendFigures;
  return {
      {{.key = one_of_range("method", key, all_methods(), "how opacity is asked for"),
        .heading = "method",
        .leads = true},
       [](const B& b) { return std::string(name_of(b.method)); }},
      {{.key = level(12, key, without_levels).if_any(), .heading = "level", .leads = true},
       [](const B& b) { return b.level ? Value(std::uint64_t{*b.level}) : Value(); }},
      {{.key = one_of(
            "by", key, {"shader", "fixed"},
            "who blends what maps say is opaque: the any-hit shader, or a fixed function in traversal"),
        .heading = "blended by",
        .leads = true},
       [](const B& b) { return std::string(b.by == render::BlendedBy::shader ? "shader" : "fixed"); }},
      {{count("candidates", same, "hits on triangles that have a surface"), "candidates"},
       [](const B& b) { return b.counts.candidates; }},
      {{count("ignored", more, "that a map says are transparent"), "ignored"},
       [](const B& b) { return b.counts.ignored; }},
      {{count("fixed", more, "that a fixed function blends"), "fixed"},
       [](const B& b) { return b.counts.opaque; }},
      {{count("any_hit", less,
              "the rest: any-hit calls, which read the texture, and blend where it is opaque"),
        "any-hit"},
       [](const B& b) { return b.counts.shader; }},
      {{share("saved", about_more, "1 - any_hit / that of texture"), "saved", "", percents(2)},
       [](const B& b) { return b.saved; }},
      {{count("texels", less, "read by the any-hit calls"), "texels"},
       [](const B& b) { return b.counts.fetches; }},
      {{count("differing", less, "pixels whose payload or accepted hit is not that of texture"), "differing"},
       [](const B& b) { return b.differing; }},
      {{count("spoiled", left_out,
              "pixels whose payload would be another one, were hits blended as they are met"),
        "as met"},
       [](const B& b) { return b.spoiled; }},
      {{time("cpu_ms", "ms of processor time a frame, the least"), "CPU", "ms", digits(1)},
       [](const B& b) { return 1e3 * b.cpu_seconds; }},
      {{ratio("times_texture", speed_less, "cpu_ms / that of texture"), "x texture"},
       [](const B& b) { return b.times_texture; }},
  };
}

}  // namespace

Result render_tables(const RenderFigures& figures) {
  using F = RenderFigures;
  using P = RenderPictureFile;
  const Fields<F> members{
      {{.key = text("file", left_out)}, [](const F& f) { return f.file; }},
      {{count("triangles", same, "of the file"), "triangles"}, [](const F& f) { return f.triangles; }},
      {{count("placed", same, "the same, as often as nodes place them"), "placed"},
       [](const F& f) { return f.placed; }},
      {{count("tested", same, "triangles that get micromaps"), "with micromaps"},
       [](const F& f) { return f.tested; }},
      {{count("tested_placed", same, "the same, as often as nodes place them"), "of these, placed"},
       [](const F& f) { return f.tested_placed; }},
      {{count("unplanned", same,
              "triangles whose alpha a texture tests and that the plan leaves out: the texture decides, "
              "whatever the method"),
        "tested, and left out of the plan"},
       [](const F& f) { return f.unplanned; }},
      {{count("rays", same, "primary, one a pixel"), "primary rays"},
       [](const F& f) { return f.methods.front().counts.rays; }},
      {{count("shadow_rays", same, "one where a primary ray hits"), "shadow rays"},
       [](const F& f) { return f.methods.front().counts.shadow_rays; }},
      {{count("ambient_rays", same, "of ambient occlusion, from each hit; not there without any").if_any(),
        "rays of ambient occlusion"},
       [](const F& f) {
         const std::uint64_t rays = f.methods.front().counts.ambient_rays;
         return rays == 0 ? Value() : Value(rays);
       }},
  };
  const Fields<P> pictures{
      {{.key = one_of("shows", key, {"seen", "blended", "heat"},
                      "seen: the picture of the last method; blended: the same where hits blend; heat: "
                      "any-hit calls a pixel, method by method"),
        .heading = "picture",
        .leads = true},
       [](const P& p) { return p.shows; }},
      {{text("file", left_out, "a PNG, from the folder that the program was called in"), "file"},
       [](const P& p) { return p.file; }},
  };
  Result result{
      .topic = "render",
      .description = "mmverify render: what rays of a scene met, opacity by texture and by micromaps",
      .settings = {{text("embree", left_out, "the ray tracer and its version"), figures.embree},
                   {whole("width", setting, {1, 4096}, "pixels"), std::uint64_t{figures.width}},
                   {whole("height", setting, {1, 4096}, "pixels"), std::uint64_t{figures.height}},
                   {count("camera", setting, "0: all of the scene; else a number of the random path"),
                    figures.camera},
                   {count("seed", setting, "of the random path"), figures.seed},
                   {count("threads", left_out, "worker threads; 0: as many as the machine has"),
                    figures.threads}},
      .about = figures.file +
               ": any-hit: candidates that the texture decides; known: the share of candidates on triangles "
               "with micromaps that a map decides; predicted: the same by the maps' area; even: the same, "
               "met by rays from everywhere; bytes: of maps, records and indices, of texture its texels; "
               "differing: pixels whose rays met another triangle, t or light than with the texture alone",
      .tables = {
          table_of<F>({.form = Form::members}, members, {figures}),
          table_of<MethodFigures>({.key = "rows"}, method_fields(figures.states == 2), figures.methods)}};
  add_ambient(result, figures.ambient);
  if (figures.states == 2)
    result.settings.push_back({one_of("states", setting, {std::uint64_t{2}},
                                      "of maps and bitmasks; there where these have no unknown states, and "
                                      "pictures differ from the texture's")
                                   .if_any(),
                               std::uint64_t{2}});
  if (!figures.blends.empty()) {
    result.settings.push_back({one_of("blend", setting, {"max", "min", "add"},
                                      "the operation by which hits blend; there where blends is")
                                   .if_any(),
                               figures.operation});
    result.tables.push_back(table_of<render::BlendFigures>(
        {.key = list("blends",
                     "hits on surfaces blend into the ray's payload; not there where none was asked for")
                    .if_any(),
         .caption = "hits on surfaces blend by " + figures.operation +
                    ", and the ray goes on; fixed: candidates that a fixed function blends; saved: of the "
                    "any-hit calls of the texture alone; differing: pixels whose payload is not the "
                    "texture's; as met: pixels that would differ, were hits blended as they are met"},
        blend_fields(), figures.blends));
  }
  if (!figures.colours.empty()) {
    result.settings.push_back(
        {one_of("colours", setting, {"faces", "vertices"},
                "what the attribute micromaps of base colours have values of; not there without such maps")
             .if_any(),
         figures.colours});
    result.settings.push_back(
        {count("colour_level", setting, "of these maps").if_any(), figures.colour_level});
    result.settings.push_back(
        {count("colour_bytes", left_out, "of these maps: values and records, equal maps of a geometry once")
             .if_any(),
         figures.colour_bytes});
  }
  if (!figures.pictures.empty())
    result.tables.push_back(table_of<P>(
        {.key = list("pictures", "that the run wrote; not there where none was asked for").if_any()},
        pictures, figures.pictures));
  return result;
}

}  // namespace mmverify::bench
