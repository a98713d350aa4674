#include "proofs/tree/dialogue.hpp"

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {
namespace {

std::string question(const char* what, Level n, Format f, std::span<const std::uint8_t> bytes) {
  return fmt::format("{} {} {} {}", what, n, bits(f), bytes.empty() ? "-" : hex(bytes));
}

/// The bytes of an answer; nothing for no_answer.
std::optional<Bytes> bytes_of(const std::string& answer) { return bytes_from_hex(answer); }

/// The program's code of a map, or a code that it has read.
struct Answered {
  Bytes code;
  std::optional<Bytes> map = {};  ///< the map of a code that was read
};

SubjectPtr on_pipe(pipe::Ask ask) {
  Functions s;
  s.encode = [ask](const Map& map) {
    // An encoder that gave no code has an empty one, which is none of the paper's.
    return coded(
        map.level, map.format,
        Answered{bytes_of(ask(question("encode", map.level, map.format, map.packed))).value_or(Bytes{})});
  };
  s.decode = [ask](const Code& c) {
    const Answered& answered = form_of<Answered>(c);
    if (answered.map) return *answered.map;
    return bytes_of(ask(question("decode", c.level, c.format, answered.code))).value_or(Bytes{});
  };
  s.bytes = [](const Code& c) { return form_of<Answered>(c).code; };
  s.open = [ask](Level n, Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
    const auto map = bytes_of(ask(question("decode", n, f, bytes)));
    if (!map) return std::nullopt;
    return coded(n, f, Answered{Bytes(bytes.begin(), bytes.end()), map});
  };
  s.writes_paper = s.reads_paper = true;
  return std::make_shared<TreeSubject>("standard input", "answers on a pipe", std::move(s));
}

/// The specification's answer.  Domain: one of the questions above.
std::string right_answer(const std::string& text) {
  static const TreeSubjectPtr right = built_in("tree-spec");
  const Functions& s = right->functions;
  const std::size_t last = text.rfind(' ');
  const Format f = text[last - 1] == '1' ? Format::two_state : Format::four_state;
  const Level n = static_cast<Level>(std::stoul(text.substr(text.find(' '))));
  const Bytes bytes = bytes_of(text.substr(last + 1)).value_or(Bytes{});
  if (text.starts_with("encode")) return hex(s.bytes(s.encode({n, f, bytes})));
  const auto code = s.open(n, f, bytes);
  return code ? hex(s.decode(*code)) : pipe::no_answer;
}

}  // namespace

const pipe::Dialogue dialogue{on_pipe, right_answer};

}  // namespace mmverify::proofs::tree
