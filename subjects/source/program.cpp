#include "subjects/source/program.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace mmverify::source {
namespace {

/// The signature of an operation. Operands: w a word, f a float, b a word of one bit, o a word of 64 bits, *
/// any; for the result also = as the first operand, 2 as the second.
struct Form {
  const char* name;
  const char* takes;
  char gives;
};

// This table has the order of enum Op.
constexpr std::array forms{
    Form{"input_u", "", 'f'},    Form{"input_v", "", 'f'},     Form{"constant", "", '*'},
    Form{"unset", "", '*'},      Form{"add", "ww", '='},       Form{"sub", "ww", '='},
    Form{"mul", "ww", '='},      Form{"udiv", "ww", '='},      Form{"urem", "ww", '='},
    Form{"sdiv", "ww", '='},     Form{"srem", "ww", '='},      Form{"shl", "ww", '='},
    Form{"lshr", "ww", '='},     Form{"ashr", "ww", '='},      Form{"and", "ww", '='},
    Form{"or", "ww", '='},       Form{"xor", "ww", '='},       Form{"eq", "ww", 'b'},
    Form{"ne", "ww", 'b'},       Form{"ult", "ww", 'b'},       Form{"ule", "ww", 'b'},
    Form{"slt", "ww", 'b'},      Form{"sle", "ww", 'b'},       Form{"select", "b**", '2'},
    Form{"zext", "w", 'w'},      Form{"sext", "w", 'w'},       Form{"trunc", "w", 'w'},
    Form{"ctpop", "w", '='},     Form{"ctlz", "w", '='},       Form{"cttz", "w", '='},
    Form{"bswap", "w", '='},     Form{"bitreverse", "w", '='}, Form{"fshl", "www", '='},
    Form{"fshr", "www", '='},    Form{"abs", "w", '='},        Form{"umin", "ww", '='},
    Form{"umax", "ww", '='},     Form{"smin", "ww", '='},      Form{"smax", "ww", '='},
    Form{"uadd_sat", "ww", '='}, Form{"usub_sat", "ww", '='},  Form{"sadd_sat", "ww", '='},
    Form{"ssub_sat", "ww", '='}, Form{"read", "*", '='},       Form{"freeze", "*", '='},
    Form{"poisoned", "*", 'b'},  Form{"table", "o", '*'},      Form{"bits_of", "f", 'w'},
    Form{"float_of", "w", 'f'},  Form{"fadd", "ff", '='},      Form{"fsub", "ff", '='},
    Form{"fmul", "ff", '='},     Form{"fdiv", "ff", '='},      Form{"fma", "fff", '='},
    Form{"fneg", "f", '='},      Form{"fabs", "f", '='},       Form{"copysign", "ff", '='},
    Form{"fcmp", "ff", 'b'},     Form{"fmin", "ff", '='},      Form{"fmax", "ff", '='},
    Form{"floor", "f", '='},     Form{"ceil", "f", '='},       Form{"ftrunc", "f", '='},
    Form{"round", "f", '='},     Form{"roundeven", "f", '='},  Form{"fptoui", "f", 'w'},
    Form{"fptosi", "f", 'w'},    Form{"fptoui_sat", "f", 'w'}, Form{"fptosi_sat", "f", 'w'},
    Form{"uitofp", "w", 'f'},    Form{"sitofp", "w", 'f'},     Form{"fpext", "f", 'f'},
    Form{"fptrunc", "f", 'f'},
};
static_assert(forms.size() == static_cast<std::size_t>(Op::fptrunc) + 1);

const Form& form_of(Op op) { return forms[static_cast<std::size_t>(op)]; }

bool is(char sort, Type t) {
  switch (sort) {
    case 'w': return !t.floating;
    case 'f': return t.floating;
    case 'b': return !t.floating && t.bits == 1;
    case 'o': return !t.floating && t.bits == 64;
    default: return true;
  }
}

/// The fault of a node that would come next; empty if it has none.
std::string fault(const Program& program, const Node& node) {
  const Form& form = form_of(node.op);
  const std::string_view takes = form.takes;
  if (node.of.size() != takes.size()) return "takes " + std::to_string(takes.size()) + " operands";
  const auto type = [&](std::size_t k) { return program.nodes[node.of[k]].type; };
  for (std::size_t k = 0; k < node.of.size(); ++k) {
    if (node.of[k] >= program.nodes.size()) return "an operand comes later";
    if (!is(takes[k], type(k))) return "an operand is of another sort";
  }
  const std::size_t first = node.op == Op::select ? 1 : 0;
  // Operands have one type, except for the condition of select.
  for (std::size_t k = first + 1; k < node.of.size(); ++k)
    if (type(k) != type(first)) return "its operands are of different types";
  if (!is(form.gives, node.type)) return "its result is of another sort";
  if ((form.gives == '=' && node.type != type(0)) || (form.gives == '2' && node.type != type(1)))
    return "its result is of another type than its operands";
  const unsigned bits = node.type.bits, from = node.of.empty() ? 0 : type(0).bits;
  if ((node.op == Op::zext || node.op == Op::sext || node.op == Op::fpext) && bits <= from)
    return "its result is no wider";
  if ((node.op == Op::trunc || node.op == Op::fptrunc) && bits >= from) return "its result is no narrower";
  if ((node.op == Op::bits_of || node.op == Op::float_of) && bits != from)
    return "its result is of another size";
  if (node.op == Op::bswap && bits % 16 != 0) return "takes an even number of bytes";
  if ((node.op == Op::input_u || node.op == Op::input_v) && bits != 32) return "is of 32 bits";
  const std::size_t numbers = node.numbers.size();
  if (node.op == Op::table ? numbers < 2 || node.numbers[0] == 0
                           : numbers != (node.op == Op::constant || node.op == Op::fcmp ? 1 : 0))
    return "has another count of numbers";
  if (node.op == Op::fcmp && node.numbers[0] > 15) return "its number is from 0 to 15";
  return {};
}

Type read_type(const std::string& text) {
  const unsigned long bits =
      text.size() > 1 && text.size() < 4 && text.find_first_not_of("0123456789", 1) == text.npos
          ? std::stoul(text.substr(1))
          : 0;
  const Type type{text[0] == 'f', static_cast<unsigned>(bits)};
  const bool good = type.floating ? bits == 32 || bits == 64 : text[0] == 'i' && bits >= 1 && bits <= 64;
  if (!good) throw BadProgram("no type: " + text);
  return type;
}

Node read_node(const std::string& name, std::istringstream& words) {
  Node node;
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const Form& f) { return f.name == name; });
  if (found == forms.end()) throw BadProgram("no operation: " + name);
  node.op = static_cast<Op>(found - forms.begin());
  std::string word;
  if (!(words >> word)) throw BadProgram("no type");
  node.type = read_type(word);
  char part = ' ';
  while (words >> word) {
    if (word == "@") {
      std::getline(words >> std::ws, node.where);
      break;
    }
    if (word == ":" || word == "!") {
      part = word[0];
      continue;
    }
    if (word.size() > 20 || word.find_first_not_of("0123456789") != word.npos)
      throw BadProgram("no number: " + word);
    const std::uint64_t k = std::stoull(word);
    if (part == ' ')
      node.of.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(k, 0xffffffff)));
    else if (part == ':')
      node.numbers.push_back(k);
    else
      node.flags = static_cast<unsigned>(k & 15);
  }
  return node;
}

}  // namespace

std::string_view to_string(Op op) { return form_of(op).name; }

std::string to_text(const Program& program) {
  std::ostringstream out;
  for (const Node& node : program.nodes) {
    out << to_string(node.op) << ' ' << (node.type.floating ? 'f' : 'i') << node.type.bits;
    for (const std::uint32_t k : node.of) out << ' ' << k;
    if (!node.numbers.empty()) out << " :";
    for (const std::uint64_t k : node.numbers) out << ' ' << k;
    if (node.flags != 0) out << " ! " << node.flags;
    if (!node.where.empty()) out << " @ " << node.where;
    out << '\n';
  }
  for (const Forbidden& f : program.forbidden) out << "forbidden " << f.node << ' ' << f.what << '\n';
  out << "result " << program.result << '\n';
  return out.str();
}

Program read_program(const std::string& text) {
  Program program;
  std::istringstream lines(text);
  bool ended = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      if (ended) throw BadProgram("something after the result");
      std::istringstream words(line);
      std::string name;
      words >> name;
      const auto node_number = [&] {
        std::uint32_t k = 0;
        if (!(words >> k) || k >= program.nodes.size() || program.nodes[k].type.floating)
          throw BadProgram("no word's number");
        return k;
      };
      if (name == "result") {
        program.result = node_number();
        if (program.nodes[program.result].type.bits != 32) throw BadProgram("a result of 32 bits is due");
        ended = true;
      } else if (name == "forbidden") {
        Forbidden f{node_number(), {}};
        if (program.nodes[f.node].type.bits != 1) throw BadProgram("one bit is due");
        std::getline(words >> std::ws, f.what);
        program.forbidden.push_back(std::move(f));
      } else {
        Node node = read_node(name, words);
        if (const std::string why = fault(program, node); !why.empty()) throw BadProgram(name + " " + why);
        program.nodes.push_back(std::move(node));
      }
    } catch (const std::exception& why) {
      throw BadProgram("line " + std::to_string(number) + ": " + why.what());
    }
  }
  if (!ended) throw BadProgram("it has no result");
  return program;
}

}  // namespace mmverify::source
