// The questions of a topic's laws as lines of text, for programs in any language, and the laws on what these answer.
//
// Laws draw cases, and ask more than one question about some. They run twice: on a subject that is right, which notes
// each question down, and on one whose answers were read. A wrong subject is asked no more than a right one: a law ends
// a case at the first wrong answer.
#pragma once

#include <cstdio>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::proofs::pipe {

/// An answer in pairs of hexadecimal digits, or none.
inline constexpr char no_answer[] = "-";

/// What answers a question, both of them a line.  Calls come from one thread.
using Ask = std::function<std::string(const std::string& question)>;

/// What a topic needs for it.
struct Dialogue {
  SubjectPtr (*subject)(Ask);                          ///< of the topic, named "standard input"
  std::string (*answer)(const std::string& question);  ///< the right one
};

/// Which laws, on what.
struct Asked {
  std::string topic;
  Dialogue dialogue;
  std::vector<const Law*> laws;
  std::vector<std::string> chosen;  ///< as `laws` were named; none for all that ask
  Levels levels;
  std::size_t errors = 1;
  std::uint64_t seed = 1, cases = 0;  ///< as in Run
  bool show_progress = false;
};

/// Writes each question once, "CASE QUESTION", CASE counting from 0; the first line starts with # and says what
/// they depend on, the last how many there were. False where `out` no longer takes anything, or the run was interrupted.
bool generate_questions(const Asked& asked, std::FILE* out);

/// Reads the answers, "CASE ANSWER", all of them in the order of the cases, and judges them.  Throws BadAnswers.
/// Memory: an answer each, and 24 bytes.
Report check_questions(const Asked& asked, std::istream& in);

}  // namespace mmverify::proofs::pipe
