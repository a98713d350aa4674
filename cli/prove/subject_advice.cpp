#include "cli/prove/subject_advice.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "cli/arguments/arguments.hpp"
#include "cli/arguments/nearest_word.hpp"
#include "cli/prove/shader.hpp"
#include "proofs/registry/plugin.hpp"
#include "subjects/dock/elf_symbols.hpp"

namespace mmverify::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char entry_point[] = "mmverify_subject_v1";

/// The declared name behind a C++ compiler's symbol; empty if it is no such symbol.
std::string demangled(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 && name != nullptr ? name.get() : "";
}

/// The first symbol that has the words in its name; empty if none has.
std::string with_words(const std::vector<std::string>& symbols, const std::string& words) {
  const auto found = std::find_if(symbols.begin(), symbols.end(),
                                  [&](const std::string& s) { return s.find(words) != std::string::npos; });
  return found == symbols.end() ? "" : *found;
}

std::string advice_on_entry_point(const dock::ElfSymbols& symbols) {
  const std::string exported = with_words(symbols.exported, "mmverify_subject_v");
  if (exported.starts_with("_Z"))
    return fmt::format(
        "; it exports {}, the C++ name of {}: include mmverify_subject.h, or write extern \"C\" before the "
        "function",
        exported, demangled(exported));
  if (!exported.empty() && exported != std::string(entry_point) + "_not_here")
    return fmt::format("; it exports {}, and this program calls {}", exported, entry_point);
  if (!with_words(symbols.hidden, entry_point).empty())
    return fmt::format(
        "; the function is in the library but hidden, as -fvisibility=hidden hides it: write "
        "__attribute__((visibility(\"default\"))) before it");
  const std::string near = nearest_word(entry_point, symbols.exported);
  return near.empty()
             ? "; docs/SUBJECTS.md and examples/subject/subject.c show this function; for a source: --source"
             : fmt::format("; it exports {}, which is spelt otherwise", near);
}

}  // namespace

bool is_library_or_shader(const std::string& name) {
  return proofs::plugin_name(name).file.ends_with(".so") || is_shader(name);
}

std::string as_path(const std::string& name) {
  return shell_quoted(name.find('/') == std::string::npos ? "./" + name : name);
}

std::string way_to_build(const std::string& name) {
  const fs::path path(name);
  const std::string ending = path.extension().string();
  const std::string library = shell_quoted(path.stem().string() + ".so"), file = shell_quoted(name);
  const auto is_one_of = [&](std::initializer_list<const char*> endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  const bool is_c = ending == ".c";
  if (is_c || is_one_of({".cpp", ".cc", ".cxx", ".C"}))
    return fmt::format(
        "a source; build it: {} -O2 -shared -fPIC -I FOLDER -o {} {} (mmverify_subject.h lies in FOLDER), "
        "then "
        "--subject ./{}; or prove its index function: mmverify prove index.floats --source {} --function "
        "NAME",
        is_c ? "cc" : "c++", library, file, library, file);
  if (is_one_of({".h", ".hpp", ".hxx"}))
    return fmt::format(
        "a header; prove its index function: mmverify prove index.floats --source {} --function NAME", file);
  if (is_one_of({".o", ".obj"}))
    return fmt::format("an object file; link it: cc -shared -o {} {}, then --subject ./{}", library, file,
                       library);
  if (ending == ".a")
    return fmt::format(
        "an archive; link it: cc -shared -o {} -Wl,--whole-archive {} -Wl,--no-whole-archive, then --subject "
        "./{}",
        library, file, library);
  return {};
}

std::string meant_as_subject(const std::string& name) {
  std::error_code none;
  if (!way_to_build(name).empty() && fs::exists(name, none))
    return fmt::format("; it is {}", way_to_build(name));
  if (is_library_or_shader(name) || name.find('/') != std::string::npos)
    return fmt::format("; did you mean --subject {}?", as_path(name));
  return {};
}

std::string advice_on_library(const std::string& file, const std::string& why) {
  if (why.find(std::string("does not export ") + entry_point) != std::string::npos) {
    const auto symbols = dock::elf_symbols(file);
    return symbols ? advice_on_entry_point(*symbols) : "";
  }
  constexpr std::string_view begins = "undefined symbol: ";
  const std::size_t at = why.find(begins);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begins.size();
  const std::string declared = demangled(why.substr(from, why.find_first_of(" ,;\n", from) - from));
  if (declared.empty()) return "; link the library that defines it";
  return fmt::format(
      "; that is the C++ name of {}: link the file that defines it, and declare a function of C as extern "
      "\"C\"",
      declared);
}

}  // namespace mmverify::cli
