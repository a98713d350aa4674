#include "proofs/bake/dialogue.hpp"

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {
namespace {

std::string question(Case one, Level n, Format format) {
  one.drawn.clear();
  return fmt::format("{} {} {}", n, static_cast<unsigned>(format), text_of(one));
}

SubjectPtr on_pipe(pipe::Ask ask) {
  Functions functions;
  functions.bake = [ask](const Case& one, Level n, Format format) -> std::optional<Baked> {
    const std::string answer = ask(question(one, n, format));
    const std::size_t due = packed_bytes(n, format);
    const auto map = bytes_from_hex(answer);
    if (!map) return std::nullopt;
    if (map->size() != due)
      throw SubjectBroken(fmt::format("a map of {} bytes was answered where {} are due, for {}", map->size(),
                                      due, question(one, n, format)));
    return unpacked(*map, n, format);
  };
  return std::make_shared<BakeSubject>("standard input", "answers on a pipe", std::move(functions));
}

/// Domain: a question as above.
std::string right_answer(const std::string& text) {
  static const BakeSubjectPtr right = built_in("bake");
  const std::size_t first = text.find(' '), second = text.find(' ', first + 1);
  const Level n = static_cast<Level>(std::stoul(text));
  const Format format = text[second - 1] == '1' ? Format::two_state : Format::four_state;
  return hex(
      packed(right->functions.bake(case_from(text.substr(second + 1)), n, format).value().states, format));
}

}  // namespace

const pipe::Dialogue dialogue{on_pipe, right_answer};

}  // namespace mmverify::proofs::bake
