#include "cli/describe/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "cli/output/exit_code.hpp"

namespace mmverify::cli::describe {
namespace {

/// Escapes a text for roff: hyphens become \-, and no line begins with a dot or an apostrophe, which would be
/// a request.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\'')
      out += "\\(aq";
    else if (c == '`')
      out += "\\(ga";
    else
      out += c;
  }
  return out;
}

std::string manual_option(const Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(fmt::format("\\fB{}\\fR", roff(name)));
  std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (!option.value.empty()) text += fmt::format(" \\fI{}\\fR", roff(option.value));
  if (option.many) text += " ...";
  if (option.required) text += " (required)";
  text += "\n" + roff(option.says);
  if (!option.words.empty()) {
    std::vector<std::string> words;
    for (const std::string& word : option.words) words.push_back(fmt::format("\\fB{}\\fR", roff(word)));
    text += fmt::format(" [{}]", fmt::join(words, ", "));
  }
  return text + "\n";
}

/// An example for each command that has one.
std::string example(const std::string& command) {
  static const std::map<std::string, const char*> lines{
      {"list", "mmverify list tree"},
      {"prove", "mmverify prove index --subject ./mine.so --no-mutants"},
      {"merge", "mmverify merge shard-1.json shard-2.json -o whole.json"},
      {"replay", "mmverify replay index.equals_reference --level 3 --case u=3/8,v=1/4 --subject ./mine.so"},
      {"bench", "mmverify bench tree --levels 4..6"},
      {"scene", "mmverify scene garden.gltf -o garden.glb"},
      {"attributes", "mmverify attributes leaf.gltf"},
      {"render", "mmverify render garden.gltf --level 2..6 --heat heat.png"},
      {"views", "mmverify views leaf.gltf"},
      {"gate", "mmverify gate --baseline baseline.json result.json"},
      {"report", "mmverify report result.json -o report.html"},
      {"gen", "mmverify gen index --level 5 | my-program | mmverify check index --level 5"},
      {"check", "mmverify check maps garden.glb"},
      {"validate", "mmverify validate assets --api khr --sarif findings.sarif"},
      {"paper", "mmverify paper som --figure 5"},
      {"repair", "mmverify repair garden.glb -o repaired.glb"},
      {"vectors", "mmverify vectors -o vectors"},
      {"schema", "mmverify schema bench"},
      {"completion", "source <(mmverify completion bash)"},
      {"man", "mmverify man | man -l -"}};
  const auto line = lines.find(command);
  return line == lines.end() ? std::string() : line->second;
}

std::string manual_command(const std::string& program, const Command& command) {
  std::string text = fmt::format(".SS {} {}\n{}.\n.PP\n\\fB{} {}\\fR", program, command.name,
                                 roff(command.says), program, command.name);
  if (!command.options.empty()) text += " [\\fIoption\\fR ...]";
  for (const Option& p : command.positionals)
    text += fmt::format(" {}\\fI{}\\fR{}{}", p.required ? "" : "[", roff(p.names[0]), p.many ? " ..." : "",
                        p.required ? "" : "]");
  text += "\n";
  for (const Option& option : command.positionals) text += manual_option(option);
  for (const Option& option : command.options) text += manual_option(option);
  if (!command.more.empty()) text += ".PP\n" + roff(command.more) + "\n";
  if (const std::string line = example(command.name); !line.empty())
    text += fmt::format(".PP\nExample:\n.PP\n.nf\n{}\n.fi\n", roff(line));
  return text;
}

}  // namespace

std::string manual(const Program& program, const std::string& version, const std::string& date) {
  const std::size_t colon = program.says.find(": ");
  std::string text = fmt::format(
      ".\\\" Written by `{0} man`.\n.TH {1} 1 \"{2}\" \"{0} {3}\" \"User Commands\"\n"
      ".SH NAME\n{0} \\- {4}\n.SH SYNOPSIS\n\\fB{0}\\fR \\fIcommand\\fR [\\fIoption\\fR ...] "
      "[\\fIargument\\fR ...]\n"
      ".SH DESCRIPTION\n"
      "An opacity micromap cuts a triangle into micro\\-triangles and stores a state for each.\n"
      "{0} has each of its algorithms twice, as a specification in rational numbers and as a fast library.\n"
      "Laws compare the two, or your own code with them.\n"
      "A law is \\fBproved\\fR where every case of its domain was run or a prover settled it.\n"
      "A sample that passes is \\fBchecked\\fR.\n"
      "What is wrong is \\fBrefuted\\fR, with the simplest input that shows it.\n"
      ".SH OPTIONS\n",
      program.name, "MMVERIFY", date, version,
      colon == std::string::npos ? program.says : program.says.substr(colon + 2));
  for (const Option& option : program.options) text += manual_option(option);
  text += ".SH COMMANDS\n";
  for (const Command& command : program.commands) text += manual_command(program.name, command);
  text += ".SH EXIT STATUS\n";
  for (std::size_t code = 0; code < exit_meanings.size(); ++code)
    text += fmt::format(".TP\n.B {}\n{}\n", code, roff(std::string(exit_meanings[code])));
  text +=
      ".SH ENVIRONMENT\n"
      ".TP\n.B MMVERIFY_CLANG\nThe compiler of \\-\\-source; clang where it is not set.\n"
      ".TP\n.B MMVERIFY_CODEC_PROVER\nThe prover of a codec's laws; mmverify\\-codec of this program where "
      "it is not set.\n"
      ".TP\n.B MMVERIFY_SHADER_LIBRARY\nThe library that runs shaders; the installed one where it is not "
      "set.\n"
      ".TP\n.B MMVERIFY_UNCONFINED\n1: a library under test may start programs, as a driver\\(aqs compiler "
      "does.\n"
      ".TP\n.B MMVERIFY_WORKER\nThe program that calls a library under test; the installed one where it is "
      "not set.\n"
      ".TP\n.B MMVERIFY_WORKER_MEMORY\nThe memory of a library under test, in MiB; 4096 where it is not "
      "set.\n"
      ".TP\n.B SOURCE_DATE_EPOCH\nThe date of this page, in seconds since 1970.\n"
      ".SH FILES\n"
      ".TP\n.I share/doc/mmverify/docs\nThe documents; begin with README.md in the folder above.\n"
      ".TP\n.I share/doc/mmverify/examples\nSubjects in C, programs on a pipe, the library in an engine.\n";
  return text;
}

}  // namespace mmverify::cli::describe
