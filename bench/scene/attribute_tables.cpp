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
      {{key + "plain", "plain bytes", "", {}, group},
       [at](const SetLevel& s) { return packed_value(at(s), &scene::PackedBytes::plain); }},
      {{key + "bytes", "packed", "", {}, group},
       [at](const SetLevel& s) { return packed_value(at(s), &scene::PackedBytes::packed); }},
      {{key + "of_plain", "of plain", "", {1, 'f', per_cent, "%"}, group},
       [at](const SetLevel& s) {
         return at(s).packed ? Value(share_of(at(s).packed->packed, at(s).packed->plain)) : Value();
       }},
      {{key + "entropy", "entropy", "", {}, group},
       [at](const SetLevel& s) { return packed_value(at(s), &scene::PackedBytes::entropy); }},
      {{key + "zstd", "zstd", "", {}, group},
       [at](const SetLevel& s) {
         return at(s).packed && at(s).packed->peer ? Value(*at(s).packed->peer) : Value();
       }},
      {{key + "worst_error", "worst", "codes", {}, group},
       [at](const SetLevel& s) {
         return at(s).packed ? Value(std::uint64_t{at(s).packed->worst_error}) : Value();
       }},
      {{key + "rms_error", "RMS", "codes", {.digits = 3}, group},
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
      {{key + "maps", "maps", "", {}, group}, [at](const SetLevel& s) { return at(s).maps.distinct; }},
      {{key + "constant", "constant", "", {}, group},
       [at](const SetLevel& s) { return at(s).maps.constant; }},
      {{key + "bytes", "bytes", "", {}, group}, [at](const SetLevel& s) { return at(s).bytes(); }},
      {{key + "of_textures", "of textures", "", {2, 'f', per_cent, "%"}, group},
       [at](const SetLevel& s) { return share_of(at(s).bytes(), s.texture_bytes); }},
      {{key + "rmse", "RMSE", "codes", {.digits = 3}, group},
       [at](const SetLevel& s) { return optional(at(s).error.rmse); }},
      {{key + "flip", "FLIP", "", {.digits = 4}, group},
       [at](const SetLevel& s) { return optional(at(s).error.flip); }},
  };
  if (of_faces) {
    fields.push_back({{key + "unseen", "without texel", "", {1, 'f', per_cent, "%"}, group},
                      [at](const SetLevel& s) { return optional(at(s).unseen); }});
  } else {
    fields.push_back({{key + "nearest_rmse", "RMSE", "codes", {.digits = 3}, "nearest vertex"},
                      [at](const SetLevel& s) { return optional(at(s).nearest->rmse); }});
    fields.push_back({{key + "nearest_flip", "FLIP", "", {.digits = 4}, "nearest vertex"},
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
    case scene::AmongSizes::within:
      return "within";
    case scene::AmongSizes::coarsest_is_closer:
      return "all are closer";
    case scene::AmongSizes::finest_is_farther:
      break;
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
      {{key + "error", flip ? "FLIP" : "RMSE", flip ? "" : "codes", {.digits = flip ? 4 : 3}, group},
       [measure](const B& b) { return optional(error_by(b.at->error, measure)); }},
      {{key + "where", "among sizes", "", {}, group},
       [measure](const B& b) -> Value {
         const auto textures = textures_at(b, measure);
         return textures ? Value(name_of(textures->where)) : Value();
       }},
      {{key + coder.key, coder.format + " bytes", "", {}, group},
       [bytes](const B& b) {
         const auto textures = bytes(b);
         return textures ? Value(*textures) : Value();
       }},
      {{key + "plain_to_" + coder.key, "plain to it", "", {}, group},
       [times](const B& b) { return times(b, &scene::PackedBytes::plain); }},
      {{key + "packed_to_" + coder.key, "packed to it", "", {}, group},
       [times](const B& b) { return times(b, &scene::PackedBytes::packed); }},
  };
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
  const Print shares{2, 'f', per_cent, "%"};
  const Fields<SetBlocks> of_blocks{
      {{.key = "set", .heading = "attributes", .leads = true}, [](const SetBlocks& s) { return s.set; }},
      {{.key = "block", .heading = "block", .leads = true},
       [](const SetBlocks& s) { return s.textures->block.name(); }},
      {{.key = "reduced", .heading = "reduced by", .leads = true},
       [](const SetBlocks& s) { return std::uint64_t{s.textures->reduced}; }},
      {{"bytes", "bytes"}, [](const SetBlocks& s) { return s.textures->bytes; }},
      {{"of_textures", "of textures", "", shares},
       [](const SetBlocks& s) { return share_of(s.textures->bytes, s.texture_bytes); }},
      {{"shown", "blocks shown", "", {1, 'f', per_cent, "%"}},
       [](const SetBlocks& s) { return share_of(s.textures->shown_bytes, s.textures->bytes); }},
      {{"rmse", "RMSE", "codes", {.digits = 3}},
       [](const SetBlocks& s) { return optional(s.textures->error.rmse); }},
      {{"flip", "FLIP", "", {.digits = 4}},
       [](const SetBlocks& s) { return optional(s.textures->error.flip); }},
  };
  Fields<BesideTextures> beside{
      {{.key = "set", .heading = "attributes", .leads = true}, [](const BesideTextures& b) { return b.set; }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const BesideTextures& b) { return std::uint64_t{b.at->level}; }},
      {{.key = "maps", .heading = "maps of", .leads = true},
       [](const BesideTextures& b) -> Value {
         return std::string(b.at->kind == MapKind::faces ? "faces" : "vertices");
       }},
      {{"plain", "plain bytes"},
       [](const BesideTextures& b) { return packed_value(*b.at, &scene::PackedBytes::plain); }},
      {{"packed", "packed"},
       [](const BesideTextures& b) { return packed_value(*b.at, &scene::PackedBytes::packed); }},
  };
  for (const Measure measure : {Measure::flip, Measure::rmse})
    for (const Field<BesideTextures>& field : equal_fields(measure, coder)) beside.push_back(field);
  return {
      table_of<SetBlocks>({.key = coder.key, .caption = "textures in " + coder.format}, of_blocks, blocks),
      table_of<BesideTextures>(
          {.key = "beside_" + coder.key, .caption = "maps beside " + coder.format + " of the same error"},
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

std::vector<LeftOutFigures> left_out(const scene::AttributeScene& read) {
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
  const Fields<F> whole{
      {{"file"}, [](const F& f) { return f.file; }},
      {{"triangles", "triangles"}, [](const F& f) { return f.triangles; }},
      {{"images", "textures"}, [](const F& f) { return f.images; }},
      {{"texture_bytes", "bytes of textures, 4 a texel, no mips"},
       [](const F& f) { return f.texture_bytes; }},
      {{"far", "maps left out, of triangles over 2^24 texels"}, [](const F& f) { return f.far; }},
      {{"beyond_textures.faces", "level from which on faces take more than the textures"},
       beyond(MapKind::faces)},
      {{"beyond_textures.faces_found", "  measured, or reckoned with as many maps as at the last level"},
       found(MapKind::faces)},
      {{"beyond_textures.vertices", "the same of vertices"}, beyond(MapKind::vertices)},
      {{"beyond_textures.vertices_found", "  measured or reckoned"}, found(MapKind::vertices)},
  };
  const Fields<S> sets{
      {{.key = "set", .heading = "attributes", .leads = true}, [](const S& s) { return scene::name(s.set); }},
      {{"triangles", "triangles"}, [](const S& s) { return s.triangles; }},
      {{"images", "textures"}, [](const S& s) { return s.images; }},
      {{"texture_bytes", "bytes"}, [](const S& s) { return s.texture_bytes; }},
      {{"shown", "shown", "", {1, 'f', per_cent, "%"}},
       [](const S& s) { return share_of(s.shown, s.texels); }},
  };
  Fields<SetLevel> rows{
      {{.key = "set", .heading = "attributes", .leads = true}, [](const SetLevel& s) { return s.set; }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const SetLevel& s) { return std::uint64_t{s.level}; }}};
  for (const MapKind kind : scene::map_kinds)
    for (const Field<SetLevel>& field : fields_of(kind)) rows.push_back(field);
  if (options.packed)
    for (const MapKind kind : scene::map_kinds)
      for (const Field<SetLevel>& field : packed_fields(kind)) rows.push_back(field);
  using A = AllAtLevel;
  const auto share = [](std::uint64_t A::*bytes) {
    return [bytes](const A& a) { return share_of(a.*bytes, a.texture_bytes); };
  };
  const Print per_cents{2, 'f', per_cent, "%"};
  const Fields<A> all{
      {{.key = "level", .heading = "level", .leads = true},
       [](const A& a) { return std::uint64_t{a.level}; }},
      {{"faces.bytes", "bytes", "", {}, "faces"}, [](const A& a) { return a.faces; }},
      {{"faces.of_textures", "of textures", "", per_cents, "faces"}, share(&A::faces)},
      {{"vertices.bytes", "bytes", "", {}, "vertices"}, [](const A& a) { return a.vertices; }},
      {{"vertices.of_textures", "of textures", "", per_cents, "vertices"}, share(&A::vertices)},
  };
  const Fields<LeftOutFigures> reasons{
      {{.key = "why", .heading = "left out", .leads = true}, [](const LeftOutFigures& l) { return l.why; }},
      {{"primitives", "primitives"}, [](const LeftOutFigures& l) { return l.primitives; }},
      {{"triangles", "triangles"}, [](const LeftOutFigures& l) { return l.triangles; }},
  };
  const std::string averaging =
      options.averaging == scene::Averaging::codes ? "codes" : "light and directions";
  Result result{
      .topic = "scene_attributes",
      .settings = {{"averaging", averaging}},
      .about =
          figures.file +
          ": each triangle's textures become micromaps, all of one level, 4 bytes a value. Averages are of " +
          (options.averaging == scene::Averaging::codes
               ? "codes as the texture stores them"
               : "light, where codes are colours, and of directions, where they are normals") +
          ". maps: different ones, for equal ones are stored once; constant: those of one value, which need "
          "no map. Errors are in texture space, over the texels whose centre a triangle shows. without "
          "texel: faces in which no texel's centre lies",
      .tables = {table_of<F>({.form = Form::members}, whole, {figures}),
                 table_of<S>({.key = "sets"}, sets, figures.sets),
                 table_of<SetLevel>({.key = "rows"}, rows, set_levels(figures)),
                 table_of<A>({.key = "totals", .caption = "all attributes"}, all, all_levels(figures))},
      .drawn = scene_attribute_picture(figures, options.texture_coder.format)};
  if (options.packed) {
    result.settings.emplace_back("packed_error", std::uint64_t{options.packed_error});
    result.about +=
        ". packed: the maps in the channels in use, lossless or each code off by the error at most; entropy: "
        "order 0 of its residuals; zstd: level 19 of the plain bytes; worst, RMS: how far what is decoded is "
        "from the maps";
  }
  if (options.texture_coder.compress) {
    result.settings.emplace_back(options.texture_coder.key, options.texture_coder.name);
    for (Table& table : coder_tables(figures, options.texture_coder))
      result.tables.push_back(std::move(table));
    result.about +=
        ". ASTC: all blocks of the textures, no mips; reduced by: sides so many times shorter first, sampled "
        "bilinearly in the end. Equal error: between two sizes, on a line of logarithms of bytes and errors";
  }
  if (!read.left_out.empty())
    result.tables.push_back(table_of<LeftOutFigures>({.key = "left_out"}, reasons, left_out(read)));
  return result;
}

Table attribute_pictures_table(const std::vector<AttributePictureFile>& pictures) {
  using P = AttributePictureFile;
  const Fields<P> fields{
      {{.key = "set", .heading = "attributes", .leads = true}, [](const P& p) { return p.set; }},
      {{.key = "image", .heading = "picture", .leads = true}, [](const P& p) { return p.image; }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const P& p) { return std::uint64_t{p.level}; }},
      {{"file", "file"}, [](const P& p) { return p.file; }},
  };
  return table_of<P>({.key = "pictures"}, fields, pictures);
}

}  // namespace mmverify::bench
