#include "subjects/shaders/compile/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>

#include "subjects/program/own_folder.hpp"
#include "subjects/shaders/compile/includes.hpp"
#include "subjects/shaders/compile/interface.hpp"
#include "subjects/shaders/compile/sha256.hpp"
#include "subjects/shaders/compile/snippet.hpp"
#include "subjects/shaders/compile/tools.hpp"

namespace mmverify::shaders {

namespace fs = std::filesystem;

namespace {

using program::ProgramEnd;

/// The compiler's first message about the file, FILE:LINE: TEXT, and the number of further ones.
std::string message(const std::string& printed, const std::string& ours, const std::string& file) {
  std::string first;
  std::size_t more = 0;
  std::istringstream in(printed);
  for (std::string line; std::getline(in, line);) {
    constexpr std::string_view begins = "ERROR: ";
    if (!line.starts_with(begins) || line.find("compilation errors") != std::string::npos ||
        line.find("compilation terminated") != std::string::npos)
      continue;
    line = line.substr(begins.size());
    if (line.starts_with(ours)) line = file + line.substr(ours.size());
    // If a snippet leaves a brace open, the compiler reports a line of our part after the snippet's end.
    if (line.starts_with(own_part)) line = fmt::format("{}: after its end, in {}", file, line);
    if (first.empty())
      first = line;
    else
      ++more;
  }
  if (first.empty()) return file + ": " + printed;
  return more == 0 ? first : fmt::format("{} (and {} more)", first, more);
}

/// The source's text without a byte order mark: some editors write one at the start of UTF-8, and compilers
/// refuse it.
std::string source_of(const std::string& file) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  std::string text = contents_of(file);
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

/// The compiler of a file's language.
class Compiler {
 public:
  Compiler(const ShaderName& name, const program::Folder& folder)
      : file_(name.file), folder_(folder), language_(language_of(name.file)) {}

  Language language() const { return language_; }

  /// The shader's text without comments, macros and includes.
  std::string preprocess(const std::string& text) const {
    if (language_ == Language::slang) return without_comments(text);
    const std::string source = folder_.file("preprocessed" + suffix());
    write_file(source, text);
    auto words = glslang(source);
    words.push_back("-E");
    // Preprocessing needs less memory than compilation; a file that includes itself uses all it may.
    return printed_by(words, source, std::uint64_t{192} << 20);
  }

  /// Compiles `text` to SPIR-V in the file `spirv`.
  void compile(const std::string& text, const std::string& spirv, bool all_functions = false) const {
    const std::string source = spirv + suffix();
    write_file(source, text);
    if (language_ == Language::slang) {
      printed_by({"slangc", "-target", "spirv", "-entry", "main", "-stage", "compute", "-I", include_root(),
                  "-o", spirv, source},
                 source);
      return;
    }
    auto words = glslang(source);
    words.insert(words.end(), {"-V", "--target-env", "vulkan1.1", "-o", spirv});
    // Without optimization, since otherwise HLSL's functions are inlined.
    if (all_functions) words.insert(words.end(), {"-g", "--keep-uncalled", "-Od"});
    const std::string printed = printed_by(words, source);
    if (all_functions) refuse_dropped(printed, source);
  }

 private:
  /// Throws BadShader if the compiler has dropped an attribute of a loop, such as max_iterations, which other
  /// compilers take for true.
  void refuse_dropped(const std::string& printed, const std::string& source) const {
    std::istringstream in(printed);
    for (std::string line; std::getline(in, line);) {
      const std::size_t at = line.find("attribute requires a SPIR-V");
      constexpr std::string_view begins = "WARNING: ";
      if (at != std::string::npos && line.starts_with(begins))
        throw BadShader(message(
            "ERROR: " + line.substr(begins.size(), at - begins.size()) + "an attribute that nothing checks",
            source, file_));
    }
  }
  static Language language_of(const std::string& file) {
    if (file.ends_with(".hlsl")) return Language::hlsl;
    if (file.ends_with(".slang")) return Language::slang;
    return Language::glsl;
  }
  std::string suffix() const {
    return language_ == Language::glsl ? ".comp" : language_ == Language::hlsl ? ".hlsl" : ".slang";
  }
  std::vector<std::string> glslang(const std::string& source) const {
    const std::string own = fs::absolute(file_).parent_path().string();
    std::vector<std::string> words{"glslangValidator", "-S", "comp", "-I" + own, "-I" + include_root()};
    if (language_ == Language::hlsl) words.insert(words.end(), {"-D", "-e", "main"});
    words.push_back(source);
    return words;
  }
  static std::string without_comments(const std::string& text) {
    return std::regex_replace(text, std::regex(R"(//[^\n]*|/\*(?:[^*]|\*(?!/))*\*/)"), " ");
  }
  std::string printed_by(const std::vector<std::string>& words, const std::string& source,
                         std::uint64_t bytes_of_memory = std::uint64_t{1} << 30) const {
    const std::optional<ProgramEnd> end = ended(words, bytes_of_memory);
    if (!end) {
      if (language_ == Language::slang)
        throw NotAvailable(
            "no slangc in PATH, which compiles Slang; Debian has none, "
            "https://github.com/shader-slang/slang/releases has");
      throw NotAvailable(
          "no glslangValidator, which compiles GLSL and HLSL; install it (Debian: glslang-tools)");
    }
    if (!end->by_itself)
      throw BadShader(fmt::format("{}: {}: {}; does the file include itself?", file_, words[0], end->how));
    if (!end->succeeded) throw BadShader(message(end->out + end->errors, source, file_));
    return end->out + end->errors;
  }

  std::string file_;
  const program::Folder& folder_;
  Language language_;
};

/// Whether spirv-val was there to validate the module. Throws BadShader if the module is invalid.
bool valid(const std::string& file, const std::string& spirv, std::uint32_t version) {
  constexpr std::uint32_t spirv_1_4 = 0x00010400, spirv_1_5 = 0x00010500, spirv_1_6 = 0x00010600;
  const char* target = version >= spirv_1_6   ? "vulkan1.3"
                       : version >= spirv_1_5 ? "vulkan1.2"
                       : version >= spirv_1_4 ? "vulkan1.1spv1.4"
                                              : "vulkan1.1";
  const std::optional<ProgramEnd> end = ended({"spirv-val", "--target-env", target, spirv});
  if (!end) return false;
  if (!end->succeeded)
    throw BadShader(fmt::format("{}: spirv-val, for {}: {}", file, target, end->out + end->errors));
  return true;
}

/// Throws BadShader unless the module has one compute shader to run, or one called main, and needs only
/// capabilities that devices are opened with.
void check_entry_point(const std::string& file, const ModuleFacts& facts) {
  if (facts.function.empty()) {
    if (facts.other_entry_points.empty()) throw BadShader(file + ": it has no entry point");
    throw BadShader(fmt::format("{}: it has no compute shader; its entry points are {}", file,
                                fmt::join(facts.other_entry_points, ", ")));
  }
  if (facts.compute_entry_points.size() > 1 && facts.function != "main")
    throw BadShader(fmt::format("{}: it has {} compute shaders, {}, and none of them is called main", file,
                                facts.compute_entry_points.size(),
                                fmt::join(facts.compute_entry_points, ", ")));
  if (!facts.foreign_capabilities.empty())
    throw BadShader(
        fmt::format("{}: it declares what no device is opened with, capability {}; there are numbers of 8, "
                    "16 and 64 bits, derivatives, subgroups and float controls",
                    file, fmt::join(facts.foreign_capabilities, ", ")));
}

/// Throws BadShader if the shader uses a resource that mmverify does not bind: a driver may read anything for
/// it. Specialization constants give a warning.
void check_interface(const std::string& file, const Module& m, const program::Folder& folder,
                     Compiled& made) {
  std::optional<Interface> found;
  try {
    found = read_interface(m.file, folder);
  } catch (const std::runtime_error& why) {
    throw BadShader(fmt::format("{}: {}: {}", file, m.entry_point, why.what()));
  }
  if (!found)
    throw NotAvailable(
        "no spirv-cross, which reads what a shader wants to be given; install it (Debian: spirv-cross)");
  if (!found->faults.empty())
    throw BadShader(fmt::format(
        "{}: {}: {}{}", file, m.entry_point, found->faults.front(),
        found->faults.size() == 1 ? std::string() : fmt::format(" (and {} more)", found->faults.size() - 1)));
  if (!found->constants.empty())
    made.warnings.push_back(
        fmt::format("{}: {}: specialization constants are what the module gives them, and another value is "
                    "another shader: {}",
                    file, m.entry_point, fmt::join(found->constants, ", ")));
}

/// Reads the modules that the manifest names, and fills in the facts about them.
void describe(const std::string& file, Compiled& made) {
  std::string all;
  bool validated = true;
  for (Module& m : made.manifest.modules) {
    const std::string bytes = contents_of(m.file);
    ModuleFacts facts;
    try {
      facts = read_module(bytes);
    } catch (const std::runtime_error& why) {
      throw BadShader(fmt::format("{}: {}", file, why.what()));
    }
    validated = valid(file, m.file, facts.version) && validated;
    check_entry_point(file, facts);
    if (facts.function.find_first_of(" \n") != std::string::npos)
      throw BadShader(file + ": the name of its compute shader has a space in it");
    if (facts.group_size == 0) throw BadShader(file + ": its workgroup is not N x 1 x 1, given by LocalSize");
    check_interface(file, m, *made.files, made);
    m.function = facts.function;
    m.group_size = facts.group_size;
    const std::string hash = sha256(bytes);
    all += m.entry_point + " " + hash + "\n";
    std::string text = fmt::format(
        "SPIR-V {}.{}, {} bytes, sha256 {}, workgroup {}, {} specialization constants, {} float operations",
        facts.version >> 16 & 0xff, facts.version >> 8 & 0xff, bytes.size(), hash, facts.group_size,
        facts.spec_constants, facts.float_operations);
    if (facts.contractible != 0) text += fmt::format(", {} without NoContraction", facts.contractible);
    if (!facts.float_modes.empty()) text += fmt::format(", asks for {}", fmt::join(facts.float_modes, ", "));
    made.about.emplace_back(m.entry_point, text);
    if (facts.contractible != 0)
      made.warnings.push_back(
          fmt::format("{}: {}: {} of {} float operations have no NoContraction (`precise`), in {}: a driver "
                      "may rearrange them, 1-(1-x) to x for example",
                      file, m.entry_point, facts.contractible, facts.float_operations,
                      fmt::join(facts.contractible_in, ", ")));
  }
  if (!validated)
    made.warnings.push_back(fmt::format("{}: no spirv-val (Debian: spirv-tools): not validated", file));
  made.fingerprint = fmt::format("(sha256 {}, device {})", sha256(all).substr(0, 16), made.manifest.device);
}

/// The entry point that a whole shader answers: the named one, index_f32 by default.
std::string known_entry(const ShaderName& name) {
  std::string entry = name.entry_point.value_or("index_f32");
  const std::vector<std::string> all = entry_points();
  if (std::find(all.begin(), all.end(), entry) == all.end())
    throw BadShader(fmt::format("{}: no entry point of shaders is called {}; there are {}", name.file, entry,
                                fmt::join(all, ", ")));
  return entry;
}

void compile_source(const ShaderName& name, Compiled& made) {
  const program::Folder& folder = *made.files;
  const Compiler compiler(name, folder);
  const std::string text = source_of(name.file);
  const std::string plain =
      compiler.preprocess(text.find("#version") != std::string::npos && defines_main(text)
                              ? text
                              : preamble_and(text, name.file, compiler.language()));
  if (defines_main(plain)) {
    const std::string spirv = folder.file("whole.spv");
    compiler.compile(text, spirv);
    made.manifest.modules.push_back({known_entry(name), {}, 0, spirv});
    return;
  }
  std::vector<std::string> defined;
  for (const SnippetFunction& f : functions_in(plain)) {
    defined.emplace_back(f.entry_point);
    if (name.entry_point && *name.entry_point != f.entry_point) continue;
    const std::string spirv = folder.file(std::string(f.entry_point) + ".spv");
    compiler.compile(shader_of(text, name.file, f, compiler.language()), spirv);
    made.manifest.modules.push_back({f.entry_point, {}, 0, spirv});
  }
  if (made.manifest.modules.empty() && !defined.empty())
    throw BadShader(fmt::format("{}: it does not answer {}; it answers {}", name.file, *name.entry_point,
                                fmt::join(defined, ", ")));
  if (made.manifest.modules.empty())
    throw BadShader(name.file +
                    ": it defines neither main nor a function that could be asked, such as uint index(uint "
                    "level, float u, float v); docs/SUBJECTS.md has them all");
}

}  // namespace

std::optional<ShaderName> shader_name(const std::string& subject) {
  static const std::regex form(R"((.*\.(?:glsl|comp|hlsl|slang|spv))(?:@([A-Za-z_]\w*))?(?:@([0-9]{1,4}))?)");
  std::smatch parts;
  if (!std::regex_match(subject, parts, form)) return std::nullopt;
  ShaderName name{parts[1]};
  if (parts[2].matched) name.entry_point = parts[2].str();
  if (parts[3].matched) name.device = static_cast<std::uint32_t>(std::stoul(parts[3]));
  return name;
}

std::vector<std::string> entry_points() {
  std::vector<std::string> all;
  for (const SnippetFunction& f : snippet_functions()) all.emplace_back(f.entry_point);
  return all;
}

std::string to_text(const ShaderName& name) {
  return name.file + (name.entry_point ? "@" + *name.entry_point : "") +
         (name.device ? fmt::format("@{}", *name.device) : "");
}

Compiled compile(const ShaderName& name) {
  Compiled made;
  const auto folder = std::make_shared<const program::Folder>("shader");
  made.files = folder;
  made.manifest.device = name.device.value_or(0);
  if (name.file.ends_with(".spv")) {
    // A copy of the file: what is judged is what was read, even if the file changes.
    const std::string spirv = folder->file("whole.spv");
    write_file(spirv, contents_of(name.file));
    made.manifest.modules.push_back({known_entry(name), {}, 0, spirv});
  } else {
    compile_source(name, made);
  }
  describe(name.file, made);
  made.manifest_file = folder->file("manifest");
  write_file(made.manifest_file, to_text(made.manifest));
  return made;
}

std::string compile_function(const std::string& file, const std::string& function,
                             const program::Folder& folder) {
  const Compiler compiler({file}, folder);
  if (compiler.language() == Language::slang)
    throw BadShader(file + ": Slang's compiler keeps nothing but what an entry point calls; name its SPIR-V");
  std::string text = source_of(file);
  // A file with a #version is compiled as it is.
  const bool versioned = text.find("#version") != std::string::npos;
  const std::string plain =
      compiler.preprocess(versioned ? text : preamble_and(text, file, compiler.language()));
  if (!defines_main(plain)) {
    text = preamble_and(text, file, compiler.language());
    if (compiler.language() == Language::glsl)
      text += "void main() {}\n";
    else  // the compiler drops functions without a caller
      text += fmt::format(
          "RWStructuredBuffer<uint> mmverify_answer;\n[numthreads(1, 1, 1)] void main() {{ "
          "mmverify_answer[0] = {}(mmverify_word(0), asfloat(mmverify_word(1)), asfloat(mmverify_word(2))); "
          "}}\n",
          function);
  }
  const std::string spirv = folder.file("functions.spv");
  compiler.compile(text, spirv, true);
  return spirv;
}

std::string device_library() {
  if (const char* named = std::getenv("MMVERIFY_SHADER_LIBRARY")) return named;
  const fs::path here = program::own_folder();
  std::error_code error;
  for (const auto& place : {here / "mmverify-shaders.so", here / "../libexec/mmverify/mmverify-shaders.so"})
    if (fs::exists(place, error)) return place.string();
  throw NotAvailable(
      "mmverify-shaders.so, which runs shaders, is missing; install the release's Debian package "
      "mmverify-plugins, or, "
      "where you build the sources, libvulkan-dev, and build again");
}

}  // namespace mmverify::shaders
