// Turns a file of functions into compute shaders, one for each entry point that its functions answer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mmverify::shaders {

/// The file name in a compiler's messages about the lines after a snippet's end.
inline constexpr std::string_view own_part = "mmverify's own part";

enum class Language { glsl, hlsl, slang };

/// A function that a snippet may define, and the entry point of mmverify_subject_t that it answers. The
/// function ranked_lookup answers tree_lookup, and tree_encode with the library's encoder.
struct SnippetFunction {
  const char* entry_point;
  const char* returns;  ///< the type in GLSL; a void function writes three uvec2
  const char* name;
  const char* parameters;  ///< in GLSL, as docs/SUBJECTS.md declares them
  std::string arguments;   ///< the arguments of the call: IN0, IN1, IN2 are this element's inputs
  const char* inputs;      ///< the inputs' type
};

/// All functions, in the order of the header.
const std::vector<SnippetFunction>& snippet_functions();

/// The known functions that the text defines, with the arguments in the text's order: parameters of different types may
/// stand in any order, such as (float u, float v, uint level). Domain: preprocessed text, without comments.
std::vector<SnippetFunction> functions_in(const std::string& preprocessed);
/// Whether the text is a whole shader: it defines main.
bool defines_main(const std::string& preprocessed);

/// A compute shader that includes the snippet `text` and calls the function for each element. A compiler's
/// messages about the snippet's lines name `file`.
std::string shader_of(const std::string& text, const std::string& file, const SnippetFunction& function,
                      Language language);

/// The snippet after our preamble, without a function: the text to preprocess.
std::string preamble_and(const std::string& text, const std::string& file, Language language);

}  // namespace mmverify::shaders
