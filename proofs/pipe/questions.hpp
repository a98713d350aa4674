// The questions of a topic's laws as lines of text, for programs in any language, and the judgement of their answers.
// A law draws cases, and a case may lead to several questions.  Laws run twice: on a right subject, which collects
// the questions, and on one that gives the answers read.  The second asks no more questions than the first, since a
// law ends a case at the first wrong answer.
#pragma once

#include <cstdio>
#include <istream>

#include "proofs/engine/runner.hpp"

namespace mmverify::proofs::pipe {

/// The line of an answer that is a refusal; other answers are pairs of hexadecimal digits.
inline constexpr char no_answer[] = "-";

/// Answers a question; both are lines.  Calls come from one thread.
using Ask = std::function<std::string(const std::string& question)>;

/// The two functions that a topic provides for questions.
struct Dialogue {
  SubjectPtr (*subject)(Ask);                          ///< of the topic, named "standard input"
  std::string (*answer)(const std::string& question);  ///< the right one
};

/// A set of laws and the settings of their runs.
struct PipeRun {
  std::string topic;
  Dialogue dialogue;
  std::vector<const Law*> laws;
  std::vector<std::string>
      chosen;  ///< the names by which `laws` were chosen; empty for all laws with questions
  Levels levels;
  std::size_t errors = 1;
  std::uint64_t seed = 1, cases = 0;  ///< as in Run
  bool show_progress = false;
};

/// Writes each question once, "CASE QUESTION", CASE counting from 0.  The first line starts with # and has the
/// settings that the questions depend on, and the last has their number.  False if `out` no longer accepts lines, or
/// the run was interrupted.
bool generate_questions(const PipeRun& asked, std::FILE* out);

/// Reads the answers, "CASE ANSWER", all in the order of the cases, and judges them.  Throws BadAnswers. Memory: the
/// answers, and 24 bytes each.
Report check_questions(const PipeRun& asked, std::istream& in);

}  // namespace mmverify::proofs::pipe
