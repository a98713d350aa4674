#include "subjects/shaders/compile/snippet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string_view>

namespace mmverify::shaders {
namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// A source's leading lines, which a compiler wants first, and the rest with unchanged line numbers.
struct Split {
  std::string first, rest;
};
Split split(const std::string& text) {
  static const std::regex early(R"(\s*#\s*(version|extension)\b.*)");
  static const std::regex version(R"(\s*#\s*version\b.*)");
  Split both;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const bool moved = std::regex_match(line, early);
    if (moved && !std::regex_match(line, version)) both.first += line + "\n";
    both.rest += (moved ? std::string() : line) + "\n";
  }
  return both;
}

/// Replaces GLSL's names of vectors and casts by those of HLSL and Slang.
std::string in_hlsl(std::string text) {
  text = replaced(std::move(text), "uintBitsToFloat", "asfloat");
  text = std::regex_replace(text, std::regex("\\buvec([234])\\b"), "uint$1");
  return std::regex_replace(text, std::regex("\\bvec([234])\\b"), "float$1");
}

constexpr const char* glsl_preamble = R"(#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_GOOGLE_cpp_style_line_directive : require
{extensions}layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 4) readonly buffer mmverify_bytes_buffer {{ uint mmverify_words[]; }};
layout(push_constant) uniform mmverify_push {{ uint count, level, first, second, bytes; }} mmverify_asked;
uint mmverify_byte_count() {{ return mmverify_asked.bytes; }}
uint mmverify_word(uint at) {{ return mmverify_words[at]; }}
uint mmverify_byte(uint at) {{ return mmverify_words[at >> 2] >> (8u * (at & 3u)) & 0xffu; }}
#line 1 "{file}"
{text}
)";
constexpr const char* hlsl_preamble =
    R"({extensions}[[vk::binding(4, 0)]] StructuredBuffer<uint> mmverify_words;
struct mmverify_push {{ uint count; uint level; uint first; uint second; uint bytes; }};
[[vk::push_constant]] ConstantBuffer<mmverify_push> mmverify_asked;
uint mmverify_byte_count() {{ return mmverify_asked.bytes; }}
uint mmverify_word(uint at) {{ return mmverify_words[at]; }}
uint mmverify_byte(uint at) {{ return mmverify_words[at >> 2] >> (8u * (at & 3u)) & 0xffu; }}
#line 1 "{file}"
{text}
)";

constexpr const char* glsl_main = R"(#line 1 "{own_part}"
layout(std430, set = 0, binding = 0) readonly buffer mmverify_in0 {{ {type} mmverify_input0[]; }};
layout(std430, set = 0, binding = 1) readonly buffer mmverify_in1 {{ {type} mmverify_input1[]; }};
layout(std430, set = 0, binding = 2) readonly buffer mmverify_in2 {{ {type} mmverify_input2[]; }};
layout(std430, set = 0, binding = 3) buffer mmverify_out {{ uint mmverify_answer[]; }};
void main() {{
  uint mmverify_k = gl_GlobalInvocationID.x;
  if (mmverify_k >= mmverify_asked.count) return;
{body}}}
)";
constexpr const char* hlsl_main = R"(#line 1 "{own_part}"
[[vk::binding(0, 0)]] StructuredBuffer<{type}> mmverify_input0;
[[vk::binding(1, 0)]] StructuredBuffer<{type}> mmverify_input1;
[[vk::binding(2, 0)]] StructuredBuffer<{type}> mmverify_input2;
[[vk::binding(3, 0)]] RWStructuredBuffer<uint> mmverify_answer;
[numthreads(64, 1, 1)]
void main(uint3 mmverify_id : SV_DispatchThreadID) {{
  uint mmverify_k = mmverify_id.x;
  if (mmverify_k >= mmverify_asked.count) return;
{body}}}
)";

std::string body_of(const SnippetFunction& f, Language language) {
  std::string arguments = f.arguments;
  for (const char* n : {"0", "1", "2"})
    arguments = replaced(arguments, std::string("IN") + n, fmt::format("mmverify_input{}[mmverify_k]", n));
  for (const char* field : {"level", "first", "second"})
    arguments = replaced(arguments, std::string("$") + field, std::string("mmverify_asked.") + field);
  const std::string call = fmt::format("{}({})", f.name, arguments);
  const std::string returns = f.returns;
  const auto write = [](int of, int at, const std::string& value) {
    return of == 1 ? fmt::format("  mmverify_answer[mmverify_k] = {};\n", value)
                   : fmt::format("  mmverify_answer[mmverify_k * {}u + {}u] = {};\n", of, at, value);
  };
  const char* bits = language == Language::glsl ? "floatBitsToUint" : "asuint";
  std::string body;
  if (returns == "void") {
    body = fmt::format(
        "  uvec2 mmverify_a, mmverify_b, mmverify_c;\n  {}({}, mmverify_a, mmverify_b, mmverify_c);\n",
        f.name, arguments);
    int at = 0;
    for (const char* corner : {"a", "b", "c"})
      for (const char* axis : {"x", "y"}) body += write(6, at++, fmt::format("mmverify_{}.{}", corner, axis));
  } else if (returns == "uint") {
    body = write(1, 0, call);
  } else {
    const int values = returns.back() - '0';
    body = fmt::format("  {} mmverify_r = {};\n", returns, call);
    for (int at = 0; at < values; ++at) {
      const std::string value = fmt::format("mmverify_r.{}", "xyz"[at]);
      body += write(values, at, returns[0] == 'u' ? value : fmt::format("{}({})", bits, value));
    }
  }
  return language == Language::glsl ? body : in_hlsl(body);
}

}  // namespace

const std::vector<SnippetFunction>& snippet_functions() {
  // clang-format off
  static const std::vector<SnippetFunction> table{
      {"index_f32", "uint", "index", "uint level, float u, float v", "$level, IN0, IN1", "float"},
      {"corners", "void", "corners", "uint level, uint index, out uvec2 a, out uvec2 b, out uvec2 c", "$level, IN0", "uint"},
      {"row_index_f32", "uint", "row_index", "uint level, float u, float v", "$level, IN0, IN1", "float"},
      {"row_corners", "void", "row_corners", "uint level, uint index, out uvec2 a, out uvec2 b, out uvec2 c", "$level, IN0", "uint"},
      {"tree_lookup", "uint", "tree_lookup", "uint level, uint format, uint index", "$level, $first, IN0", "uint"},
      {"tree_lookup_f32", "uint", "tree_lookup_at", "uint level, uint format, float u, float v", "$level, $first, IN0, IN1", "float"},
      {"ranked_lookup", "uint", "ranked_lookup", "uint level, uint format, uint index", "$level, $first, IN0", "uint"},
      {"dag_lookup", "uint", "dag_lookup", "uint format, uint map, uint index", "$first, IN0, IN1", "uint"},
      {"dag_lookup_f32", "uint", "dag_lookup_at", "uint format, uint map, float u, float v",
       "$first, IN0, uintBitsToFloat(IN1), uintBitsToFloat(IN2)", "uint"},
      {"vq2_region", "uint", "vq2_region", "uint x, uint y", "IN0, IN1", "uint"},
      {"vq4_region", "uint", "vq4_region", "uint x, uint y", "IN0, IN1", "uint"},
      {"attribute_vertex_index", "uint", "vertex_index", "uint level, uint order, uint i, uint j", "$level, $first, IN0, IN1", "uint"},
      {"attribute_vertex_place", "uvec2", "vertex_place", "uint level, uint order, uint index", "$level, $first, IN0", "uint"},
      {"attribute_face_index", "uint", "face_index", "uint level, uint order, uint iu, uint iv, uint upper", "$level, $first, IN0, IN1, IN2", "uint"},
      {"attribute_face_place", "uvec3", "face_place", "uint level, uint order, uint index", "$level, $first, IN0", "uint"},
      {"attribute_triplet", "uvec3", "triplet", "uint level, uint vertex_order, uint face_order, uint face", "$level, $first, $second, IN0", "uint"},
      {"attribute_face_of", "uint", "face_of", "uint level, uint vertex_order, uint face_order, uint a, uint b, uint c", "$level, $first, $second, IN0, IN1, IN2", "uint"},
      {"attribute_triplet_f32", "uvec3", "triplet_at", "uint level, uint order, float u, float v", "$level, $first, IN0, IN1", "float"},
      {"attribute_weights_f32", "vec3", "weights", "uint level, float u, float v", "$level, IN0, IN1", "float"},
      {"attribute_decimate", "uvec2", "decimate", "uint level, uint flags, uint i, uint j", "$level, $first, IN0, IN1", "uint"},
      {"attribute_face_mip", "uint", "face_mip", "uint rounding, uint a, uint b, uint c, uint d",
       "$first, mmverify_word(4u * mmverify_k), mmverify_word(4u * mmverify_k + 1u), mmverify_word(4u * mmverify_k + 2u), mmverify_word(4u * mmverify_k + 3u)", "uint"},
      {"traverse_decide", "uint", "decide", "uint api, uint candidate, uint instance_flags, uint ray_flags", "$first, IN0, IN1, IN2", "uint"},
      {"traverse_blend", "uint", "blend", "uint operation, uint payload, uint value", "$first, IN0, IN1", "uint"},
      {"traverse_blend_hits", "uint", "blend_hits", "uint operation, uint payload, uint count",
       "$first, $second, mmverify_byte_count() / 12u", "uint"},
  };
  // clang-format on
  return table;
}

namespace {

std::vector<std::string> comma_separated(const std::string& text) {
  static const std::regex comma(R"(\s*,\s*)");
  return {std::sregex_token_iterator(text.begin(), text.end(), comma, -1), {}};
}

/// The type of a parameter, without qualifiers; empty if it is neither uint nor float.
std::string type_of(const std::string& parameter) {
  static const std::regex number(R"(^\s*(?:(?:in|const|highp)\s+)*(uint|float)\b)");
  std::smatch found;
  return std::regex_search(parameter, found, number) ? found[1].str() : "";
}

/// The function's arguments in the order of the text's parameters: those of each type keep their order.  Unchanged where
/// the types are others.
std::string arguments_for(const SnippetFunction& f, const std::string& parameters) {
  const auto due = comma_separated(f.parameters), own = comma_separated(parameters),
             arguments = comma_separated(f.arguments);
  if (due.size() != arguments.size()) return f.arguments;
  std::vector<bool> used(due.size());
  std::vector<std::string> ordered;
  for (const std::string& parameter : own)
    for (std::size_t k = 0; k < due.size(); ++k)
      if (!used[k] && type_of(due[k]) == type_of(parameter)) {
        used[k] = true;
        ordered.push_back(arguments[k]);
        break;
      }
  return ordered.size() == due.size() ? fmt::format("{}", fmt::join(ordered, ", ")) : f.arguments;
}

}  // namespace

std::vector<SnippetFunction> functions_in(const std::string& preprocessed) {
  std::vector<SnippetFunction> found;
  for (const SnippetFunction& f : snippet_functions()) {
    // A definition: the type, the name, the right number of parameters, and a brace.
    const auto commas = std::count(f.parameters, f.parameters + std::string_view(f.parameters).size(), ',');
    std::string parameters = "[^,(){};]+";
    for (auto k = commas; k > 0; --k) parameters += ",[^,(){};]+";
    const std::string returns = fmt::format("(?:{}|{})", f.returns, in_hlsl(f.returns));
    std::smatch definition;
    if (std::regex_search(
            preprocessed, definition,
            std::regex(fmt::format(R"(\b{}\s+{}\s*\(({})\)\s*\{{)", returns, f.name, parameters)))) {
      found.push_back(f);
      found.back().arguments = arguments_for(f, definition[1]);
    }
  }
  return found;
}

bool defines_main(const std::string& preprocessed) {
  return std::regex_search(preprocessed, std::regex(R"(\bvoid\s+main\s*\([^()]*\)\s*\{)"));
}

std::string preamble_and(const std::string& text, const std::string& file, Language language) {
  const Split both = split(text);
  return fmt::format(fmt::runtime(language == Language::glsl ? glsl_preamble : hlsl_preamble),
                     fmt::arg("extensions", both.first), fmt::arg("file", replaced(file, "\"", "'")),
                     fmt::arg("text", both.rest));
}

std::string shader_of(const std::string& text, const std::string& file, const SnippetFunction& function,
                      Language language) {
  return preamble_and(text, file, language) +
         fmt::format(fmt::runtime(language == Language::glsl ? glsl_main : hlsl_main),
                     fmt::arg("own_part", own_part), fmt::arg("type", function.inputs),
                     fmt::arg("body", body_of(function, language)));
}

}  // namespace mmverify::shaders
