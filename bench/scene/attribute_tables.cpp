#include "bench/scene/attribute_tables.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/attribute/equal_error.hpp"

namespace mmverify::bench {
namespace {

using scene::AttributeFigures;
using scene::AttributeSetFigures;
using scene::MapKind;
using scene::MapsAtLevel;
using scene::Measure;

/// Both kinds of an attribute set at a level.
struct SetLevel {
  std::string set;
  unsigned level;
  std::uint64_t texture_bytes;
  const MapsAtLevel *faces, *vertices;
};

/// All sets at a level.
struct AllAtLevel {
  unsigned level;
  std::uint64_t texture_bytes, faces, vertices;
};

/// Textures of a set, compressed.
struct SetBlocks {
  std::string set;
  std::uint64_t texture_bytes;
  const scene::CompressedTextures* textures;
};

/// Maps of a set, beside its textures compressed to the same error.
struct BesideTextures {
  std::string set;
  const MapsAtLevel* at;
  const std::vector<scene::CompressedTextures>* textures;
};

struct LeftOutFigures {
  std::string why;
  std::uint64_t primitives = 0, triangles = 0;
};

double share_of(std::uint64_t bytes, std::uint64_t of) {
  return static_cast<double>(bytes) / static_cast<double>(of);
}

/// The size of packed maps in one form, a column each; the peer is zstd.
Value packed_value(const MapsAtLevel& at, std::uint64_t scene::PackedBytes::*bytes) {
  return at.packed ? Value((*at.packed).*bytes) : Value();
}

/// The columns of packed maps of a kind.
Fields<SetLevel> packed_fields(MapKind kind) {
  const bool of_faces = kind == MapKind::faces;
  const std::string key = of_faces ? "faces.packed." : "vertices.packed.",
                    group = of_faces ? "faces, packed" : "vertices, packed";
  const auto at = [of_faces](const SetLevel& s) -> const MapsAtLevel& {
    return of_faces ? *s.faces : *s.vertices;
  };
  return {
      note<SetLevel>(
          object(
              of_faces ? "faces.packed" : "vertices.packed", no_rule,
              "of the channels in use, where --packed asked for it and the maps have fewer than 2^31 codes")
              .if_any()),
      {{count(key + "plain", same, "a byte a channel"), "plain bytes", "", plain, group},
       [at](const SetLevel& s) { return packed_value(at(s), &scene::PackedBytes::plain); }},
      {{count(key + "bytes", less, "packed, within the error"), "packed", "", plain, group},
       [at](const SetLevel& s) { return packed_value(at(s), &scene::PackedBytes::packed); }},
      {{number(key + "of_plain", less, "bytes / plain"), "of plain", "", percents(1), group},
       [at](const SetLevel& s) {
         return at(s).packed ? Value(share_of(at(s).packed->packed, at(s).packed->plain)) : Value();
       }},
      {{count(key + "entropy", less, "order 0 of its roots and residuals, in bytes"), "entropy", "", plain,
        group},
       [at](const SetLevel& s) { return packed_value(at(s), &scene::PackedBytes::entropy); }},
      {{count(key + "zstd", left_out,
              "bytes of the plain ones in zstd, level 19; of whichever zstd there is"),
        "zstd", "", plain, group},
       [at](const SetLevel& s) {
         return at(s).packed && at(s).packed->peer ? Value(*at(s).packed->peer) : Value();
       }},
      {{whole(key + "worst_error", less, {0, 127},
              "the most that a code decoded again is off, in codes of 8 bits"),
        "worst", "codes", plain, group},
       [at](const SetLevel& s) {
         return at(s).packed ? Value(std::uint64_t{at(s).packed->worst_error}) : Value();
       }},
      {{real(key + "rms_error", about_less, {0, 127},
             "root of the mean square of the same, over all codes of the maps, each map once"),
        "RMS", "codes", digits(3), group},
       [at](const SetLevel& s) { return at(s).packed ? Value(at(s).packed->rms_error) : Value(); }},
  };
}

Fields<SetLevel> fields_of(MapKind kind) {
  const bool of_faces = kind == MapKind::faces;
  const std::string group = of_faces ? "faces" : "vertices", key = group + ".";
  const auto at = [of_faces](const SetLevel& s) -> const MapsAtLevel& {
    return of_faces ? *s.faces : *s.vertices;
  };
  Fields<SetLevel> fields{
      {{count(key + "maps", same, "after equal ones are shared"), "maps", "", plain, group},
       [at](const SetLevel& s) { return at(s).distinct; }},
      {{count(key + "constant", same, "of these, maps of one value"), "constant", "", plain, group},
       [at](const SetLevel& s) { return at(s).constant; }},
      {{count(key + "bytes", less, "of the maps, 4 a value"), "bytes", "", plain, group},
       [at](const SetLevel& s) { return at(s).bytes(); }},
      {{number(key + "of_textures", less, "bytes / those of the set's textures"), "of textures", "",
        percents(2), group},
       [at](const SetLevel& s) { return share_of(at(s).bytes(), s.texture_bytes); }},
      {{number(key + "rmse", about_less,
               "of the texels shown, over the channels in use, in codes of 8 bits; not there where none is "
               "shown")
            .if_any(),
        "RMSE", "codes", digits(3), group},
       [at](const SetLevel& s) { return optional(at(s).error.rmse); }},
      {{number(key + "flip", about_less,
               "mean FLIP of the texels shown; not there where codes are no colours, or none is shown")
            .if_any(),
        "FLIP", "", digits(4), group},
       [at](const SetLevel& s) { return optional(at(s).error.flip); }},
  };
  if (of_faces) {
    fields.push_back(
        {{share(key + "unseen", about,
                "the share of micro-triangles without a texel's centre; not there where there is no map")
              .if_any(),
          "without texel", "", percents(1), group},
         [at](const SetLevel& s) { return optional(at(s).unseen); }});
  } else {
    fields.push_back({{number(key + "nearest_rmse", about_less,
                              "rmse in codes with the nearest micro-vertex in the place of interpolation; "
                              "not there where rmse is not")
                           .if_any(),
                       "RMSE", "codes", digits(3), "nearest vertex"},
                      [at](const SetLevel& s) { return optional(at(s).nearest->rmse); }});
    fields.push_back({{number(key + "nearest_flip", about_less, "flip of the same").if_any(), "FLIP", "",
                       digits(4), "nearest vertex"},
                      [at](const SetLevel& s) { return optional(at(s).nearest->flip); }});
  }
  return fields;
}

/// The bytes of the textures at the maps' error; none if the maps lack this measure.
std::optional<scene::BytesAtError> textures_at(const BesideTextures& b, Measure measure) {
  const std::optional<double> error = error_by(b.at->error, measure);
  if (!error) return std::nullopt;
  std::vector<scene::BytesAndError> sizes;
  for (const scene::CompressedTextures& one : *b.textures)
    sizes.push_back({static_cast<double>(one.bytes), error_by(one.error, measure).value_or(0)});
  return scene::bytes_at_error(sizes, *error);
}

std::string name_of(scene::AmongSizes where) {
  switch (where) {
    case scene::AmongSizes::within: return "within";
    case scene::AmongSizes::coarsest_is_closer: return "all are closer";
    case scene::AmongSizes::finest_is_farther: break;
  }
  return "all are farther";
}

/// The columns of textures at the maps' error, by one measure.
Fields<BesideTextures> equal_fields(Measure measure, const scene::TextureCoder& coder) {
  using B = BesideTextures;
  const bool flip = measure == Measure::flip;
  const std::string group = flip ? "at equal FLIP" : "at equal RMSE", key = flip ? "flip." : "rmse.";
  const auto bytes = [measure](const B& b) -> std::optional<std::uint64_t> {
    const auto textures = textures_at(b, measure);
    if (!textures || textures->where != scene::AmongSizes::within) return std::nullopt;
    return static_cast<std::uint64_t>(std::llround(textures->bytes));
  };
  const auto times = [bytes](const B& b, std::uint64_t scene::PackedBytes::*of) -> Value {
    const auto textures = bytes(b);
    if (!textures || !b.at->packed) return {};
    return share_of((*b.at->packed).*of, *textures);
  };
  return {
      note<B>(object(flip ? "flip" : "rmse", no_rule,
                     flip ? "textures of the maps' FLIP" : "textures of the maps' RMSE")
                  .if_any()),
      {{number(key + "error", no_rule,
               flip ? "the maps' FLIP, as in rows" : "the maps' RMSE, as in rows, in codes"),
        flip ? "FLIP" : "RMSE",
        flip ? "" : "codes",
        {.digits = flip ? 4 : 3},
        group},
       [measure](const B& b) { return optional(error_by(b.at->error, measure)); }},
      {{one_of(key + "where", no_rule, {"within", "all are closer", "all are farther"},
               "among the sizes of " + coder.key +
                   "; all are closer: the one of the fewest bytes has less error, all are farther: no size "
                   "has as little"),
        "among sizes", "", plain, group},
       [measure](const B& b) -> Value {
         const auto textures = textures_at(b, measure);
         return textures ? Value(name_of(textures->where)) : Value();
       }},
      {{whole(key + coder.key, no_rule, {16},
              "bytes, between two sizes on a line of logarithms of bytes and errors; there where within")
            .if_any(),
        coder.format + " bytes", "", plain, group},
       [bytes](const B& b) {
         const auto textures = bytes(b);
         return textures ? Value(*textures) : Value();
       }},
      {{number(key + "plain_to_" + coder.key, no_rule, "the maps' plain bytes / " + coder.key).if_any(),
        "plain to it", "", plain, group},
       [times](const B& b) { return times(b, &scene::PackedBytes::plain); }},
      {{number(key + "packed_to_" + coder.key, no_rule, "the maps' packed bytes / " + coder.key).if_any(),
        "packed to it", "", plain, group},
       [times](const B& b) { return times(b, &scene::PackedBytes::packed); }},
  };
}

std::vector<std::string> names_of(const std::vector<scene::BlockSize>& blocks) {
  std::vector<std::string> names;
  for (const scene::BlockSize& block : blocks) names.push_back(block.name());
  return names;
}

/// Textures by block size, and maps beside them.
std::vector<Table> coder_tables(const AttributeFigures& figures, const scene::TextureCoder& coder) {
  std::vector<SetBlocks> blocks;
  std::vector<BesideTextures> maps;
  for (const AttributeSetFigures& set : figures.sets) {
    if (set.compressed.empty()) continue;
    for (const scene::CompressedTextures& one : set.compressed)
      blocks.push_back({scene::name(set.set), set.texture_bytes, &one});
    for (const MapsAtLevel& at : set.levels) maps.push_back({scene::name(set.set), &at, &set.compressed});
  }
  const Print shares = percents(2);
  const Fields<SetBlocks> of_blocks{
      {{.key = set_key(), .heading = "attributes", .leads = true}, [](const SetBlocks& s) { return s.set; }},
      {{.key = one_of_range("block", no_rule, names_of(coder.blocks), "texels of a block of 16 bytes"),
        .heading = "block",
        .leads = true},
       [](const SetBlocks& s) { return s.textures->block.name(); }},
      {{.key = one_of(
            "reduced", no_rule, {1, 2, 4, 8, 16, 32},
            "sides of the textures are so many times shorter first, and sampled bilinearly in the end"),
        .heading = "reduced by",
        .leads = true},
       [](const SetBlocks& s) { return std::uint64_t{s.textures->reduced}; }},
      {{whole("bytes", no_rule, {16}, "of all blocks, without mips"), "bytes"},
       [](const SetBlocks& s) { return s.textures->bytes; }},
      {{number("of_textures", no_rule, "bytes / those of the set's textures"), "of textures", "", shares},
       [](const SetBlocks& s) { return share_of(s.textures->bytes, s.texture_bytes); }},
      {{share("shown", no_rule, "the share of blocks of which a triangle shows a texel"), "blocks shown", "",
        percents(1)},
       [](const SetBlocks& s) { return share_of(s.textures->shown_bytes, s.textures->bytes); }},
      {{number("rmse", no_rule,
               "of the texels shown, over the channels in use, in codes of 8 bits; not there where none is "
               "shown")
            .if_any(),
        "RMSE", "codes", digits(3)},
       [](const SetBlocks& s) { return optional(s.textures->error.rmse); }},
      {{number("flip", no_rule,
               "mean FLIP of the texels shown; not there where codes are no colours, or none is shown")
            .if_any(),
        "FLIP", "", digits(4)},
       [](const SetBlocks& s) { return optional(s.textures->error.flip); }},
  };
  Fields<BesideTextures> beside{
      {{.key = set_key(), .heading = "attributes", .leads = true},
       [](const BesideTextures& b) { return b.set; }},
      {{.key = level(10), .heading = "level", .leads = true},
       [](const BesideTextures& b) { return std::uint64_t{b.at->level}; }},
      {{.key = one_of("maps", no_rule, {"faces", "vertices"}), .heading = "maps of", .leads = true},
       [](const BesideTextures& b) -> Value {
         return std::string(b.at->kind == MapKind::faces ? "faces" : "vertices");
       }},
      {{count("plain", no_rule, "a byte a channel; not there where the maps have 2^31 codes or more")
            .if_any(),
        "plain bytes"},
       [](const BesideTextures& b) { return packed_value(*b.at, &scene::PackedBytes::plain); }},
      {{count("packed", no_rule, "packed, lossless").if_any(), "packed"},
       [](const BesideTextures& b) { return packed_value(*b.at, &scene::PackedBytes::packed); }},
  };
  for (const Measure measure : {Measure::flip, Measure::rmse})
    for (const Field<BesideTextures>& field : equal_fields(measure, coder)) beside.push_back(field);
  return {table_of<SetBlocks>(
              {.key = list(coder.key,
                           "textures compressed by whichever " + coder.key +
                               "enc there is, all of a set at one size; not there without --" + coder.key,
                           {1}, left_out)
                          .if_any(),
               .caption = "textures in " + coder.format},
              of_blocks, blocks),
          table_of<BesideTextures>({.key = list("beside_" + coder.key,
                                                "maps beside textures in " + coder.format +
                                                    " of the same error; not there without --" + coder.key,
                                                {2}, left_out)
                                               .if_any(),
                                    .row = "maps of a set at a level, of one kind",
                                    .caption = "maps beside " + coder.format + " of the same error"},
                                   beside, maps)};
}

std::vector<SetLevel> set_levels(const AttributeFigures& figures) {
  std::vector<SetLevel> all;
  for (const AttributeSetFigures& set : figures.sets)
    for (std::size_t k = 0; k + 1 < set.levels.size(); k += 2)
      all.push_back(
          {scene::name(set.set), set.levels[k].level, set.texture_bytes, &set.levels[k], &set.levels[k + 1]});
  return all;
}

std::vector<AllAtLevel> all_levels(const AttributeFigures& figures) {
  std::vector<AllAtLevel> all;
  for (const MapsAtLevel& at : figures.sets.front().levels)
    if (at.kind == MapKind::faces)
      all.push_back({at.level, figures.texture_bytes, figures.bytes(at.level, MapKind::faces),
                     figures.bytes(at.level, MapKind::vertices)});
  return all;
}

std::vector<LeftOutFigures> reasons_of(const scene::AttributeScene& read) {
  std::map<std::string, LeftOutFigures> by_reason;
  for (const scene::AttributeLeftOut& one : read.left_out) {
    LeftOutFigures& all = by_reason[one.why];
    all.why = one.why;
    ++all.primitives;
    all.triangles += one.triangles;
  }
  std::vector<LeftOutFigures> list;
  for (const auto& [why, all] : by_reason) list.push_back(all);
  return list;
}

}  // namespace

Result scene_attribute_tables(const AttributeFigures& figures, const scene::AttributeScene& read,
                              const scene::AttributeOptions& options) {
  using F = AttributeFigures;
  using S = AttributeSetFigures;
  const auto beyond = [](MapKind kind) {
    return [kind](const F& f) { return std::uint64_t{f.level_beyond_textures(kind)}; };
  };
  // The number of maps beyond the last measured level is an estimate.
  const auto found = [](MapKind kind) {
    return [kind](const F& f) {
      const bool measured =
          !f.sets.empty() && f.level_beyond_textures(kind) <= f.sets.front().levels.back().level;
      return std::string(measured ? "measured" : "reckoned");
    };
  };
  const Fields<F> members{
      {{text("file", left_out)}, [](const F& f) { return f.file; }},
      {{count("triangles", same, "of the file"), "triangles"}, [](const F& f) { return f.triangles; }},
      {{positive("images", same, "textures in use, each once"), "textures"},
       [](const F& f) { return f.images; }},
      {{positive("texture_bytes", same, "4 a texel, without mips"), "bytes of textures, 4 a texel, no mips"},
       [](const F& f) { return f.texture_bytes; }},
      {{count("far", same, "triangles left out: their box has over 2^24 texels"),
        "maps left out, of triangles over 2^24 texels"},
       [](const F& f) { return f.far; }},
      note<F>(object("beyond_textures", no_rule,
                     "the level from which on all maps take more than the textures; beyond the last that was "
                     "measured it is no measurement but reckoned, with as many maps as at the last")),
      {{whole("beyond_textures.faces", more, {0, 17},
              "from which on all maps take more than the textures; 17: none up to 16"),
        "level from which on faces take more than the textures"},
       beyond(MapKind::faces)},
      {{one_of("beyond_textures.faces_found", left_out, {"measured", "reckoned"},
               "measured: maps of this level were made; reckoned: of the last level's count of maps and the "
               "closed form"),
        "  measured, or reckoned with as many maps as at the last level"},
       found(MapKind::faces)},
      {{whole("beyond_textures.vertices", more, {0, 17},
              "from which on all maps take more than the textures; 17: none up to 16"),
        "the same of vertices"},
       beyond(MapKind::vertices)},
      {{one_of("beyond_textures.vertices_found", left_out, {"measured", "reckoned"},
               "measured: maps of this level were made; reckoned: of the last level's count of maps and the "
               "closed form"),
        "  measured or reckoned"},
       found(MapKind::vertices)},
  };
  const Fields<S> sets{
      {{.key = set_key(), .heading = "attributes", .leads = true},
       [](const S& s) { return scene::name(s.set); }},
      {{count("triangles", same, "with these attributes"), "triangles"},
       [](const S& s) { return s.triangles; }},
      {{positive("images", same, "their textures"), "textures"}, [](const S& s) { return s.images; }},
      {{positive("texture_bytes", same, "4 a texel, without mips"), "bytes"},
       [](const S& s) { return s.texture_bytes; }},
      {{share("shown", about, "the share of texels whose centre a triangle shows"), "shown", "", percents(1)},
       [](const S& s) { return share_of(s.shown, s.texels); }},
  };
  Fields<SetLevel> rows{
      {{.key = set_key(), .heading = "attributes", .leads = true}, [](const SetLevel& s) { return s.set; }},
      {{.key = level(10), .heading = "level", .leads = true},
       [](const SetLevel& s) { return std::uint64_t{s.level}; }}};
  for (const MapKind kind : scene::map_kinds)
    for (const Field<SetLevel>& field : fields_of(kind)) rows.push_back(field);
  if (options.packed)
    for (const MapKind kind : scene::map_kinds)
      for (const Field<SetLevel>& field : packed_fields(kind)) rows.push_back(field);
  using A = AllAtLevel;
  const auto of_textures = [](std::uint64_t A::*bytes) {
    return [bytes](const A& a) { return share_of(a.*bytes, a.texture_bytes); };
  };
  const Print per_cents = percents(2);
  const Fields<A> all{
      {{.key = level(10), .heading = "level", .leads = true},
       [](const A& a) { return std::uint64_t{a.level}; }},
      {{count("faces.bytes", less, "of all maps"), "bytes", "", plain, "faces"},
       [](const A& a) { return a.faces; }},
      {{number("faces.of_textures", less, "bytes / those of the textures"), "of textures", "", per_cents,
        "faces"},
       of_textures(&A::faces)},
      {{count("vertices.bytes", less, "of all maps"), "bytes", "", plain, "vertices"},
       [](const A& a) { return a.vertices; }},
      {{number("vertices.of_textures", less, "bytes / those of the textures"), "of textures", "", per_cents,
        "vertices"},
       of_textures(&A::vertices)},
  };
  const Fields<LeftOutFigures> reasons{
      {{.key = text("why", key), .heading = "left out", .leads = true},
       [](const LeftOutFigures& l) { return l.why; }},
      {{count("primitives", same, "of the file"), "primitives"},
       [](const LeftOutFigures& l) { return l.primitives; }},
      {{count("triangles", same, "of these"), "triangles"},
       [](const LeftOutFigures& l) { return l.triangles; }},
  };
  const std::string averaging =
      options.averaging == scene::Averaging::codes ? "codes" : "light and directions";
  Result result{
      .topic = "scene_attributes",
      .description = "mmverify attributes FILE: micromaps of a scene's attributes beside its textures",
      .settings = {{one_of("averaging", setting, {"light and directions", "codes"},
                           "light of sRGB codes and directions of normals; or codes as they are"),
                    averaging}},
      .about =
          figures.file +
          ": each triangle's textures become micromaps, all of one level, 4 bytes a value. Averages are of " +
          (options.averaging == scene::Averaging::codes
               ? "codes as the texture stores them"
               : "light, where codes are colours, and of directions, where they are normals") +
          ". maps: different ones, for equal ones are stored once; constant: those of one value, which need "
          "no map. Errors are in texture space, over the texels whose centre a triangle shows. without "
          "texel: faces in which no texel's centre lies",
      .tables = {table_of<F>({.form = Form::members}, members, {figures}),
                 table_of<S>({.key = "sets"}, sets, figures.sets),
                 table_of<SetLevel>({.key = "rows", .row = "all maps of a set at a level"}, rows,
                                    set_levels(figures)),
                 table_of<A>({.key = "totals", .row = "all sets at a level", .caption = "all attributes"},
                             all, all_levels(figures))},
      .drawn = scene_attribute_picture(figures, options.texture_coder.format)};
  if (options.packed) {
    result.settings.push_back(
        {whole("packed_error", setting, {0, 127},
               "the most that a code of the packed maps is off; not there without --packed")
             .if_any(),
         std::uint64_t{options.packed_error}});
    result.about +=
        ". packed: the maps in the channels in use, lossless or each code off by the error at most; entropy: "
        "order 0 of its residuals; zstd: level 19 of the plain bytes; worst, RMS: how far what is decoded is "
        "from the maps";
  }
  if (const scene::TextureCoder& coder = options.texture_coder; coder.compress) {
    result.settings.push_back(
        {text(coder.key, left_out,
              "the encoder of " + coder.key +
                  ", its version and how thoroughly it searches; not there without --" + coder.key)
             .if_any(),
         coder.name});
    for (Table& table : coder_tables(figures, coder)) result.tables.push_back(std::move(table));
    result.about +=
        ". ASTC: all blocks of the textures, no mips; reduced by: sides so many times shorter first, sampled "
        "bilinearly in the end. Equal error: between two sizes, on a line of logarithms of bytes and errors";
  }
  if (!read.left_out.empty())
    result.tables.push_back(table_of<LeftOutFigures>(
        {.key = list("left_out", "what gets no maps; not there where all get some").if_any()}, reasons,
        reasons_of(read)));
  return result;
}

Table attribute_pictures_table(const std::vector<AttributePictureFile>& pictures) {
  using P = AttributePictureFile;
  const Fields<P> fields{
      {{.key = set_key(), .heading = "attributes", .leads = true}, [](const P& p) { return p.set; }},
      {{.key = text("image", key, "its name, as far as files may have it"),
        .heading = "picture",
        .leads = true},
       [](const P& p) { return p.image; }},
      {{.key = level(10), .heading = "level", .leads = true},
       [](const P& p) { return std::uint64_t{p.level}; }},
      {{text("file", left_out,
             "a PNG, from the folder that the program was called in: above the texture, faces and vertices; "
             "below FLIP's scale and the FLIP of faces and of vertices"),
        "file"},
       [](const P& p) { return p.file; }},
  };
  return table_of<P>(
      {.key =
           list("pictures",
                "that the run wrote: an image beside its maps and their errors; not there without --pictures")
               .if_any()},
      fields, pictures);
}

}  // namespace mmverify::bench
