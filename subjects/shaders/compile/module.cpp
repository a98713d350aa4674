#include "subjects/shaders/compile/module.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

namespace mmverify::shaders {
namespace {

// Opcodes and numbers of SPIR-V's specification, section 3.
enum Op : std::uint32_t {
  op_name = 5,
  op_entry_point = 15,
  op_execution_mode = 16,
  op_capability = 17,
  op_spec_constant_true = 48,
  op_spec_constant_false = 49,
  op_spec_constant = 50,
  op_function = 54,
  op_decorate = 71,
  op_f_add = 129,
  op_f_sub = 131,
  op_f_mul = 133,
  op_f_div = 136,
  op_f_rem = 140,
  op_f_mod = 141,
  op_vector_times_scalar = 142,
  op_dot = 148
};
constexpr std::uint32_t magic = 0x07230203, header = 5, compute_model = 5, local_size = 17,
                        no_contraction = 42;

bool is_float_operation(std::uint32_t op) {
  return op == op_f_add || op == op_f_sub || op == op_f_mul || op == op_f_div || op == op_f_rem ||
         op == op_f_mod || (op >= op_vector_times_scalar && op <= op_dot);
}

/// Whether a capability is known: Matrix, Shader, numbers of other sizes, ImageQuery, DerivativeControl,
/// subgroups, float controls. Every device of Vulkan 1.1 has it, or a device is opened with it, or a device
/// without it is refused (Program) or refuses the module itself.
bool is_ours(std::uint32_t capability) {
  constexpr std::uint32_t ours[] = {0, 1, 9, 10, 11, 22, 39, 50, 51};
  constexpr std::uint32_t subgroups = 61, last_of_subgroups = 68, float_controls = 4464,
                          last_of_float_controls = 4468;
  return std::find(std::begin(ours), std::end(ours), capability) != std::end(ours) ||
         (capability >= subgroups && capability <= last_of_subgroups) ||
         (capability >= float_controls && capability <= last_of_float_controls);
}

/// The name of an execution mode of SPV_KHR_float_controls, with the width; empty for another mode.
std::string float_mode(std::uint32_t mode, std::uint32_t width) {
  constexpr const char* names[] = {"DenormPreserve", "DenormFlushToZero", "SignedZeroInfNanPreserve",
                                   "RoundingModeRTE", "RoundingModeRTZ"};
  constexpr std::uint32_t first = 4459;
  if (mode < first || mode >= first + std::size(names)) return {};
  return std::string(names[mode - first]) + " " + std::to_string(width);
}

/// An instruction: its opcode, and its operand words.
struct Instruction {
  std::uint32_t op;
  const std::uint32_t* words;
  std::size_t count;
  std::string text(std::size_t from) const {
    std::string found;
    for (std::size_t k = from; k < count; ++k)
      for (int shift = 0; shift < 32; shift += 8) {
        const char c = static_cast<char>(words[k] >> shift & 0xffu);
        if (c == 0) return found;
        found += c;
      }
    return found;
  }
};

std::vector<std::uint32_t> words_of(const std::string& bytes) {
  if (bytes.size() % sizeof(std::uint32_t) != 0 || bytes.size() < header * sizeof(std::uint32_t))
    throw std::runtime_error("no SPIR-V: " + std::to_string(bytes.size()) + " bytes");
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), bytes.size());
  if (words[0] != magic) throw std::runtime_error("no SPIR-V: it does not begin with its magic number");
  return words;
}

template <class Visit>
void each_instruction(const std::vector<std::uint32_t>& words, Visit visit) {
  for (std::size_t at = header; at < words.size();) {
    const std::uint32_t length = words[at] >> 16;
    if (length == 0 || length > words.size() - at)
      throw std::runtime_error("cut short or damaged at word " + std::to_string(at));
    visit(Instruction{words[at] & 0xffffu, words.data() + at + 1, length - 1});
    at += length;
  }
}

}  // namespace

ModuleFacts read_module(const std::string& bytes) {
  const auto words = words_of(bytes);
  ModuleFacts facts;
  facts.version = words[1];
  std::map<std::uint32_t, std::string> names;
  std::set<std::uint32_t> fixed;
  std::uint32_t function = 0, entry = 0;
  each_instruction(words, [&](const Instruction& i) {
    const auto has = [&](std::size_t count) { return i.count >= count; };
    if (i.op == op_name && has(1)) names[i.words[0]] = i.text(1);
    if (i.op == op_capability && has(1) && !is_ours(i.words[0]))
      facts.foreign_capabilities.push_back(i.words[0]);
    if (i.op == op_entry_point && has(2)) {
      const bool computes = i.words[0] == compute_model;
      const std::string name = i.text(2);
      (computes ? facts.compute_entry_points : facts.other_entry_points).push_back(name);
      if (computes && (facts.function.empty() || (facts.function != "main" && name == "main"))) {
        facts.function = name;
        entry = i.words[1];
      }
    }
    if (i.op == op_execution_mode && has(2) && i.words[0] == entry) {
      if (i.words[1] == local_size && has(5) && i.words[3] == 1 && i.words[4] == 1)
        facts.group_size = i.words[2];
      if (has(3))
        if (const std::string mode = float_mode(i.words[1], i.words[2]); !mode.empty())
          facts.float_modes.push_back(mode);
    }
    if (i.op == op_spec_constant || i.op == op_spec_constant_true || i.op == op_spec_constant_false)
      ++facts.spec_constants;
    if (i.op == op_decorate && has(2) && i.words[1] == no_contraction) fixed.insert(i.words[0]);
    if (i.op == op_function && has(2)) function = i.words[1];
    if (!is_float_operation(i.op) || !has(2)) return;
    ++facts.float_operations;
    if (fixed.count(i.words[1]) != 0) return;
    ++facts.contractible;
    std::string in = names.count(function) != 0 ? names[function] : "a function without a name";
    in = in.substr(0, in.find('('));
    auto& all = facts.contractible_in;
    if (std::find(all.begin(), all.end(), in) == all.end()) all.push_back(in);
  });
  return facts;
}

}  // namespace mmverify::shaders
