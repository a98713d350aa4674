#include "bench/scene/attribute_mip_tables.hpp"

#include "bench/scene/attribute_tables.hpp"

namespace mmverify::bench {
namespace {

using scene::MipError;
using scene::MipOfMaps;
using scene::MipStep;

Property mip_key() { return whole("mip", key, {0, 10}, "sides are 2^mip times shorter"); }

/// Adds the errors of one group of columns.
template <class Of>
void add_errors(Fields<MipStep>& fields, const std::string& group, Of of) {
  const std::string in = group + ".";
  fields.push_back(
      {{number(in + "rmse", no_rule, "root of the mean square, in codes of 8 bits, of the texels shown"),
        "RMSE", "codes", digits(3), group},
       [of](const MipStep& s) { return optional(of(s).all.rmse); }});
  fields.push_back(
      {{number(in + "flip", no_rule,
               "mean FLIP of the texels shown; not there where codes are no colours, or none is shown")
            .if_any(),
        "FLIP", "", digits(4), group},
       [of](const MipStep& s) { return optional(of(s).all.flip); }});
  fields.push_back({{number(in + "border_rmse", no_rule,
                            "rmse in codes of the texels near a border alone; not there where none is")
                         .if_any(),
                     "border", "codes", digits(3), group},
                    [of](const MipStep& s) { return optional(of(s).border); }});
  fields.push_back({{number(in + "interior_rmse", no_rule,
                            "rmse in codes of the other texels alone; not there where none is")
                         .if_any(),
                     "interior", "codes", digits(3), group},
                    [of](const MipStep& s) { return optional(of(s).interior); }});
}

void add_maps(Fields<MipStep>& fields, const std::string& group, MipOfMaps MipStep::*maps) {
  const std::string in = group + ".";
  fields.push_back(
      {{whole(in + "level", no_rule, {0, 10},
              "of the maps; their highest level was measured from the textures, the others are made from it"),
        "level", "", plain, group},
       [maps](const MipStep& s) { return std::uint64_t{(s.*maps).level}; }});
  fields.push_back({{number(in + "values_per_texel", no_rule, "of all triangles' maps, a texel shown"),
                     "values/texel", "", digits(4), group},
                    [maps](const MipStep& s) { return (s.*maps).values_per_texel; }});
  add_errors(fields, group, [maps](const MipStep& s) -> const MipError& { return (s.*maps).error; });
}

}  // namespace

Table attribute_mips_table(const std::vector<MipStep>& steps) {
  Fields<MipStep> fields{
      {{.key = set_key(), .heading = "attributes", .leads = true},
       [](const MipStep& s) { return scene::name(s.set); }},
      {{.key = mip_key(), .heading = "mip", .leads = true},
       [](const MipStep& s) { return std::uint64_t{s.mip}; }},
      {{share(
            "border", no_rule,
            "the share of the texels shown that are within 2^mip texels of one of another chart or of none"),
        "near a border", "", percents(1)},
       [](const MipStep& s) { return s.border_share; }},
  };
  fields.push_back(note<MipStep>(
      object("texture", no_rule, "the texture's mip: means over the whole image, enlarged bilinearly")));
  fields.push_back(note<MipStep>(
      object("faces", no_rule, "the level of faces with most nearly as many values as the mip has texels")));
  fields.push_back(note<MipStep>(object("vertices", no_rule, "the same of vertices")));
  add_errors(fields, "texture", [](const MipStep& s) -> const MipError& { return s.texture; });
  add_maps(fields, "faces", &MipStep::faces);
  add_maps(fields, "vertices", &MipStep::vertices);
  return table_of<MipStep>(
      {.key = list("mips",
                   "mips of the textures beside those of the maps, against the textures, of sets of which a "
                   "texel is shown; not there without --mips",
                   {}, left_out)
                  .if_any(),
       .caption = "mips of the textures, beside those of maps with most nearly as many values; border: "
                  "within 2^mip texels of another chart or of none"},
      fields, steps);
}

Table attribute_mip_pictures_table(const std::vector<MipPictureFile>& pictures) {
  using P = MipPictureFile;
  const Fields<P> fields{
      {{.key = set_key(), .heading = "attributes", .leads = true}, [](const P& p) { return p.set; }},
      {{.key = text("image", key, "its name, as far as files may have it"),
        .heading = "picture",
        .leads = true},
       [](const P& p) { return p.image; }},
      {{.key = mip_key(), .heading = "mip", .leads = true}, [](const P& p) { return std::uint64_t{p.mip}; }},
      {{text("file", no_rule,
             "a PNG, from the folder that the program was called in: above the texture's mip, faces and "
             "vertices; below their FLIP, grey what no triangle shows"),
        "file"},
       [](const P& p) { return p.file; }},
  };
  return table_of<P>({.key = list("mip_pictures",
                                  "that the run wrote: mips of an image beside those of its maps; not there "
                                  "without --mips and --pictures",
                                  {1}, left_out)
                                 .if_any()},
                     fields, pictures);
}

}  // namespace mmverify::bench
