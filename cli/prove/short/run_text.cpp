#include "cli/prove/short/run_text.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>

#include "cli/output/streams.hpp"
#include "cli/prove/short/answer.hpp"

namespace mmverify::cli {

using namespace proofs;

void add_details(CLI::App& command, bool& details) {
  command.add_flag("--details,--verbose", details,
                   "print every law and level, laws that do not apply, domains and mutants");
}

void RunText::note(const std::string& line) {
  if (details_)
    whole_.note(line);
  else
    notes_.push_back(line);
}

void RunText::detail(const std::string& line) {
  if (details_) whole_.note(line);
}

void RunText::add(const Result& result) {
  if (details_) whole_.add(result);
}

void RunText::finish(const Report& report, bool name_subjects, const std::vector<std::string>& last) {
  if (details_) {
    whole_.finish(report, name_subjects);
    for (const std::string& line : last) whole_.note(line);
    return;
  }
  if (isatty(STDERR_FILENO) != 0) say(stderr, "\r\033[K");
  for (const std::string& line : short_answer(report, subjects_, notes_, last))
    say(out_, "{}\n", printable(line));
  std::fflush(out_);
}

}  // namespace mmverify::cli
