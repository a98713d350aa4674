#include "bench/scene/attribute_mip_tables.hpp"

#include "bench/scene/attribute_tables.hpp"

namespace mmverify::bench {
namespace {

using scene::MipError;
using scene::MipOfMaps;
using scene::MipStep;

/// Adds the errors of one group of columns.
template <class Of>
void add_errors(Fields<MipStep>& fields, const std::string& group, Of of) {
  const std::string key = group + ".";
  fields.push_back({{key + "rmse", "RMSE", "codes", {3}, group},
                    [of](const MipStep& s) { return optional(of(s).all.rmse); }});
  fields.push_back(
      {{key + "flip", "FLIP", "", {4}, group}, [of](const MipStep& s) { return optional(of(s).all.flip); }});
  fields.push_back({{key + "border_rmse", "border", "codes", {3}, group},
                    [of](const MipStep& s) { return optional(of(s).border); }});
  fields.push_back({{key + "interior_rmse", "interior", "codes", {3}, group},
                    [of](const MipStep& s) { return optional(of(s).interior); }});
}

void add_maps(Fields<MipStep>& fields, const std::string& group, MipOfMaps MipStep::*maps) {
  const std::string key = group + ".";
  fields.push_back({{key + "level", "level", "", {}, group},
                    [maps](const MipStep& s) { return std::uint64_t{(s.*maps).level}; }});
  fields.push_back({{key + "values_per_texel", "values/texel", "", {4}, group},
                    [maps](const MipStep& s) { return (s.*maps).values_per_texel; }});
  add_errors(fields, group, [maps](const MipStep& s) -> const MipError& { return (s.*maps).error; });
}

}  // namespace

Table attribute_mips_table(const std::vector<MipStep>& steps) {
  Fields<MipStep> fields{
      {{.key = "set", .heading = "attributes", .leads = true},
       [](const MipStep& s) { return scene::name(s.set); }},
      {{.key = "mip", .heading = "mip", .leads = true},
       [](const MipStep& s) { return std::uint64_t{s.mip}; }},
      {{"border", "near a border", "", {1, 'f', per_cent, "%"}},
       [](const MipStep& s) { return s.border_share; }},
  };
  add_errors(fields, "texture", [](const MipStep& s) -> const MipError& { return s.texture; });
  add_maps(fields, "faces", &MipStep::faces);
  add_maps(fields, "vertices", &MipStep::vertices);
  return table_of<MipStep>({.key = "mips",
                            .caption = "mips of the textures, beside those of maps with most nearly as many "
                                       "values; border: within 2^mip texels of another chart or of none"},
                           fields, steps);
}

Table attribute_mip_pictures_table(const std::vector<MipPictureFile>& pictures) {
  using P = MipPictureFile;
  const Fields<P> fields{
      {{.key = "set", .heading = "attributes", .leads = true}, [](const P& p) { return p.set; }},
      {{.key = "image", .heading = "picture", .leads = true}, [](const P& p) { return p.image; }},
      {{.key = "mip", .heading = "mip", .leads = true}, [](const P& p) { return std::uint64_t{p.mip}; }},
      {{"file", "file"}, [](const P& p) { return p.file; }},
  };
  return table_of<P>({.key = "mip_pictures"}, fields, pictures);
}

}  // namespace mmverify::bench
