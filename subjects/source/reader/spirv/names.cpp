#include "subjects/source/reader/spirv/names.hpp"

#ifdef MMVERIFY_SPIRV_TOOLS
#include <spirv-tools/libspirv.h>
#endif

#include <sstream>
#include <vector>

namespace mmverify::source {
namespace {

using Words = std::vector<std::uint32_t>;

/// The words of an instruction, as a module has them.
Words words_of(const Instruction& i) {
  Words words{0};
  for (const std::uint32_t id : {i.type, i.result})
    if (id != 0) words.push_back(id);
  words.insert(words.end(), i.operands.begin(), i.operands.end());
  words[0] = static_cast<std::uint32_t>(words.size()) << 16 | i.opcode;
  return words;
}

#ifdef MMVERIFY_SPIRV_TOOLS
/// The last line of the text of these instructions; empty if SPIRV-Tools does not know them.
std::string last_line(const Words& instructions) {
  Words module{0x07230203, 0x00010600, 0, 0x7fffffff, 0};
  module.insert(module.end(), instructions.begin(), instructions.end());
  spv_context context = spvContextCreate(SPV_ENV_UNIVERSAL_1_6);
  spv_text text = nullptr;
  spv_diagnostic why = nullptr;
  spvBinaryToText(context, module.data(), module.size(), SPV_BINARY_TO_TEXT_OPTION_NO_HEADER, &text, &why);
  std::string lines = text != nullptr ? text->str : "";
  spvTextDestroy(text);
  spvDiagnosticDestroy(why);
  spvContextDestroy(context);
  while (!lines.empty() && lines.back() == '\n') lines.pop_back();
  return lines.substr(lines.rfind('\n') + 1);
}
#else
std::string last_line(const Words&) { return {}; }
#endif

/// The words of a line behind its opcode, "OpX" or "%1 = OpX".
std::vector<std::string> behind_opcode(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  bool found = false;
  for (std::string word; in >> word; found = found || word.starts_with("Op"))
    if (found) words.push_back(word);
  return words;
}

}  // namespace

std::string opcode_name(std::uint16_t opcode) {
#ifdef MMVERIFY_SPIRV_TOOLS
  if (const std::string name = spvOpcodeString(opcode); name != "unknown") return "Op" + name;
#endif
  return "opcode " + std::to_string(opcode);
}

std::string operands_text(const Instruction& i, std::size_t at, const std::string& otherwise) {
  const std::vector<std::string> words = behind_opcode(last_line(words_of(i)));
  // The text has the type's id among its operands.
  const std::size_t first = at + (i.type != 0 ? 1 : 0);
  std::string text;
  for (std::size_t k = first; k < words.size(); ++k) text += (text.empty() ? "" : " ") + words[k];
  if (text.empty() && at < i.operands.size()) return otherwise + " " + std::to_string(i.operands[at]);
  return text;
}

std::string extended_name(std::uint32_t instruction) {
  constexpr std::uint32_t set = 1;
  const Instruction import{spv::ExtInstImport, 0, set, {0x4c534c47, 0x6474732e, 0x3035342e, 0}};
  // The number of operands does not count for the name, but the text needs it: three are the most.
  for (std::size_t operands = 1; operands <= 3; ++operands) {
    Instruction call{spv::ExtInst, 2, 3, {set, instruction}};
    call.operands.insert(call.operands.end(), operands, 4);
    Words both = words_of(import);
    const Words words = words_of(call);
    both.insert(both.end(), words.begin(), words.end());
    const std::vector<std::string> text = behind_opcode(last_line(both));
    if (text.size() > 2) return text[2];
  }
  return "instruction " + std::to_string(instruction);
}

}  // namespace mmverify::source
