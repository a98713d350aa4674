// A file that defines functions becomes compute shaders, one for each entry point that its functions answer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mmverify::shaders {

/// What a compiler's messages about the lines after a snippet's end begin with.
inline constexpr std::string_view own_part = "mmverify's own part";

enum class Language { glsl, hlsl, slang };

/// A function that a snippet may define, and the entry point of mmverify_subject_t that it answers; ranked_lookup: both
/// tree_encode, which is the library's, and tree_lookup.
struct SnippetFunction {
  const char* entry_point;
  const char* returns;  ///< GLSL's name of the type; of void, three uvec2 are written
  const char* name;
  const char* parameters;  ///< as docs/SUBJECTS.md declares them, in GLSL
  const char* arguments;   ///< what it is called with: IN0, IN1, IN2 are this element's inputs
  const char* inputs;      ///< their type
};

/// All of them, in the header's order.
const std::vector<SnippetFunction>& snippet_functions();

/// Those that the text defines.  Domain: preprocessed text, without comments.
std::vector<SnippetFunction> functions_in(const std::string& preprocessed);
/// Whether it is a whole shader instead: it defines main.
bool defines_main(const std::string& preprocessed);

/// A compute shader that includes the snippet `text` and asks the function of each element.  Messages of a compiler about
/// the snippet's lines name `file`.
std::string shader_of(const std::string& text, const std::string& file, const SnippetFunction& function,
                      Language language);

/// The same without a function: what the snippet is preprocessed with.
std::string preamble_and(const std::string& text, const std::string& file, Language language);

}  // namespace mmverify::shaders
