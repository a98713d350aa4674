#include "subjects/source/reader/spirv/module.hpp"

#include <algorithm>
#include <cstring>

#include "subjects/source/reader/module.hpp"

namespace mmverify::source {
namespace {

constexpr std::uint32_t magic = 0x07230203, swapped_magic = 0x03022307;
constexpr std::size_t header_words = 5;
constexpr std::uint32_t fast_math = 40;  // a decoration

std::uint32_t swapped(std::uint32_t w) { return w << 24 | (w & 0xff00) << 8 | (w >> 8 & 0xff00) | w >> 24; }

std::uint32_t first_word(const std::string& bytes) {
  std::uint32_t word = 0;
  if (bytes.size() >= sizeof word) std::memcpy(&word, bytes.data(), sizeof word);
  return word;
}

/// The ids that an instruction begins with: a type and a result, a result alone, or neither.
enum class Head { none, result, both };
Head head_of(std::uint16_t opcode) {
  switch (opcode) {
    case spv::String:
    case spv::ExtInstImport:
    case spv::Label: return Head::result;
    case spv::Store:
    case spv::NoLine:
    case spv::Line:
    case spv::Name:
    case spv::FunctionEnd: return Head::none;
    default: break;
  }
  if (opcode >= spv::TypeVoid && opcode <= 38) return Head::result;
  const bool makes_nothing = opcode == 0 || opcode == 39 || (opcode >= 2 && opcode <= 10) ||
                             (opcode >= 13 && opcode <= 18) || (opcode >= 62 && opcode <= 64) ||
                             (opcode >= 71 && opcode <= 76) || (opcode >= spv::LoopMerge && opcode <= 257) ||
                             opcode == 218 || opcode == 219 || opcode == 99 ||
                             (opcode >= 220 && opcode <= 225) || opcode == 228 || opcode == 330 ||
                             opcode == 331 || opcode == 332 || opcode >= 4416;
  return makes_nothing ? Head::none : Head::both;
}

}  // namespace

bool is_spirv(const std::string& bytes) {
  return first_word(bytes) == magic || first_word(bytes) == swapped_magic;
}

std::string text_at(const std::vector<std::uint32_t>& operands, std::size_t at) {
  std::string text;
  for (; at < operands.size(); ++at)
    for (unsigned k = 0; k < 32; k += 8) {
      const char c = static_cast<char>(operands[at] >> k & 0xff);
      if (c == 0) return text;
      text += c;
    }
  throw CannotRead("no valid SPIR-V: a text without an end");
}

bool SpirvModule::is_decorated(std::uint32_t id, std::uint32_t decoration) const {
  const auto found = decorations.find(id);
  return found != decorations.end() &&
         std::any_of(found->second.begin(), found->second.end(),
                     [&](const Instruction& i) { return i.operands[1] == decoration; });
}

namespace {

[[noreturn]] void bad(const std::string& why) { throw CannotRead("no valid SPIR-V: " + why); }

void decorate(SpirvModule& module, const Instruction& i) {
  if (i.operands.size() < 2) bad("a decoration has too few operands");
  module.decorations[i.operands[0]].push_back(i);
  if (i.operands[1] == fast_math)
    module.foreign_promises.push_back("FPFastMathMode, which leaves values open");
}

void decorate_member(SpirvModule& module, const Instruction& i) {
  if (i.operands.size() < 3) bad("a decoration has too few operands");
  module.members[i.operands[0]].push_back(i);
  if (i.operands[2] == spv::RelaxedPrecision)
    module.foreign_promises.push_back("RelaxedPrecision of a member: a device may compute in 16 bits");
}

/// Gives the decorations of a group to all that the instruction names: ids, or structures with members.
void decorate_by_group(SpirvModule& module, const Instruction& i) {
  const bool members = i.opcode == spv::GroupMemberDecorate;
  const std::vector<Instruction> group =
      i.operands.empty() ? std::vector<Instruction>() : module.decorations[i.operands[0]];
  for (std::size_t k = 1; k + (members ? 1 : 0) < i.operands.size(); k += members ? 2 : 1)
    for (Instruction one : group) {
      one.opcode = members ? spv::MemberDecorate : spv::Decorate;
      one.operands[0] = i.operands[k];
      if (members) one.operands.insert(one.operands.begin() + 1, i.operands[k + 1]);
      members ? decorate_member(module, one) : decorate(module, one);
    }
}

/// Records a decoration, or an execution mode that changes binary32 operations.
void annotate(SpirvModule& module, const Instruction& i) {
  constexpr std::uint32_t flush_to_zero = 4460, round_to_zero = 4463;
  switch (i.opcode) {
    case spv::ExecutionMode:
      if (i.operands.size() < 3 || i.operands[2] < 32) return;
      if (i.operands[1] == flush_to_zero)
        module.foreign_promises.push_back("DenormFlushToZero: subnormal numbers are not kept");
      if (i.operands[1] == round_to_zero)
        module.foreign_promises.push_back("RoundingModeRTZ: numbers are not rounded to nearest");
      return;
    case spv::MemberDecorate:
    case spv::MemberDecorateString: return decorate_member(module, i);
    case spv::GroupDecorate:
    case spv::GroupMemberDecorate: return decorate_by_group(module, i);
    default: return decorate(module, i);
  }
}

/// The instruction at a word; `at` becomes that of the next one.
Instruction instruction_at(const std::vector<std::uint32_t>& words, std::size_t& at) {
  const std::size_t count = words[at] >> 16;
  if (count == 0 || at + count > words.size())
    bad("an instruction at word " + std::to_string(at) + " is cut short");
  Instruction i{static_cast<std::uint16_t>(words[at] & 0xffff)};
  const Head head = head_of(i.opcode);
  std::size_t next = at + 1;
  at += count;
  if (head == Head::both && next < at) i.type = words[next++];
  if (head != Head::none) {
    if (next >= at) bad("an instruction has no result");
    i.result = words[next++];
  }
  i.operands.assign(words.begin() + static_cast<std::ptrdiff_t>(next),
                    words.begin() + static_cast<std::ptrdiff_t>(at));
  return i;
}

/// Begins a function, adds a parameter to it, or ends it; inside: the function that is not ended yet, or null.
void frame_function(SpirvModule& module, SpirvFunction*& inside, const Instruction& i) {
  switch (i.opcode) {
    case spv::Function:
      if (inside != nullptr) bad("a function in a function");
      if (i.operands.size() < 2) bad("an instruction has too few operands");
      module.functions.push_back({i, {}, {}});
      inside = &module.functions.back();
      return;
    case spv::FunctionParameter:
      if (inside == nullptr || !inside->body.empty()) bad("a parameter of no function");
      inside->parameters.push_back(i);
      return;
    default:
      if (inside == nullptr) bad("the end of no function");
      inside = nullptr;
  }
}

/// All words, in this machine's order of bytes.
std::vector<std::uint32_t> module_words(const std::string& bytes) {
  if (bytes.size() % 4 != 0 || bytes.size() < 4 * header_words) bad("it is cut short");
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  if (words[0] == swapped_magic)
    for (std::uint32_t& w : words) w = swapped(w);
  return words;
}

}  // namespace

SpirvModule read_spirv_module(const std::string& bytes) {
  const std::vector<std::uint32_t> words = module_words(bytes);
  SpirvModule module;
  SpirvFunction* inside = nullptr;
  std::uint32_t file = 0, line = 0;
  for (std::size_t at = header_words; at < words.size();) {
    Instruction i = instruction_at(words, at);
    i.file = file;
    i.line = line;
    const auto needs = [&](std::size_t operands) {
      if (i.operands.size() < operands) bad("an instruction has too few operands");
    };
    switch (i.opcode) {
      case spv::Name:
        needs(2);
        module.names[i.operands[0]] = text_at(i.operands, 1);
        break;
      case spv::String: module.strings[i.result] = text_at(i.operands, 0); break;
      case spv::ExtInstImport: module.sets[i.result] = text_at(i.operands, 0); break;
      case spv::Line:
        needs(3);
        file = i.operands[0];
        line = i.operands[1];
        break;
      case spv::NoLine: file = line = 0; break;
      case spv::ExecutionMode:
      case spv::Decorate:
      case spv::DecorateId:
      case spv::DecorateString:
      case spv::MemberDecorate:
      case spv::MemberDecorateString:
      case spv::GroupDecorate:
      case spv::GroupMemberDecorate: annotate(module, i); break;
      case spv::FunctionEnd: file = line = 0; [[fallthrough]];
      case spv::Function:
      case spv::FunctionParameter: frame_function(module, inside, i); break;
      default:
        if (inside != nullptr) {
          inside->body.push_back(i);
        } else if (i.result != 0) {
          module.globals[i.result] = i;
        }
    }
  }
  if (inside != nullptr) bad("a function without an end");
  return module;
}

}  // namespace mmverify::source
