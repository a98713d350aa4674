#include "cli/prove/second_solver.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "proofs/certificate/statements.hpp"
#include "subjects/program/folder.hpp"
#include "subjects/program/program.hpp"

namespace mmverify::cli {
namespace {

using proofs::certificate::Statements;

/// Statements of a sample, evenly apart, the last one among them.
constexpr std::size_t most_asked = 32;

template <class Writer>
void write_file(const std::string& name, Writer writer) {
  std::ofstream out(name);
  writer(out);
  if (!out.flush()) throw EnvironmentError(name + ": it cannot be written");
}

constexpr double longest_whole = 30;  ///< seconds for all statements of a proof at once

}  // namespace

SecondSolver::Answer SecondSolver::ask(const std::string& file, double seconds,
                                       const std::function<void()>& stop) const {
  const program::Bounds bounds{std::chrono::seconds(static_cast<std::int64_t>(std::ceil(seconds)))};
  program::ProgramEnd end;
  try {
    end = program::run_program({program_, file}, {}, stop, bounds);
  } catch (const program::NoProgram& why) {
    throw EnvironmentError(fmt::format("--second-solver {}", why.what()));
  }
  if (end.how == "exit code 20") return {Answer::Kind::impossible, {}};
  if (end.how == "exit code 10")
    return {Answer::Kind::possible, "it finds values that satisfy it, so one of the two solvers is wrong"};
  return {Answer::Kind::none, fmt::format("it gives no answer ({})", end.how)};
}

std::optional<std::string> SecondSolver::disagrees(const std::string& certificate, bool whole,
                                                   const std::string& kept, double seconds,
                                                   const std::function<void()>& stop) {
  std::ifstream in(certificate);
  const Statements all(in);
  if (all.size() == 0) return std::nullopt;
  const program::Folder folder("second-solver");
  const std::string file = folder.file("question.cnf");
  const auto doubt = [&](const Answer& answer) {
    std::filesystem::copy_file(file, kept, std::filesystem::copy_options::overwrite_existing);
    return fmt::format("{} was asked about {}: {}", program_, kept, answer.why);
  };
  if (whole) {
    write_file(file, [&](std::ostream& out) { all.write_all(out); });
    const Answer answer = ask(file, std::min(seconds, longest_whole), stop);
    if (answer.kind == Answer::Kind::possible) return doubt(answer);
    if (answer.kind == Answer::Kind::impossible) {
      opinion_.whole += all.size();
      return std::nullopt;
    }
  }
  const std::size_t asked = std::min(most_asked, all.size());
  for (std::size_t k = 1; k <= asked; ++k) {
    write_file(file, [&](std::ostream& out) { all.write_one(out, k * all.size() / asked - 1); });
    if (const Answer answer = ask(file, seconds, stop); answer.kind != Answer::Kind::impossible)
      return doubt(answer);
  }
  opinion_.asked += asked;
  opinion_.sampled += all.size();
  return std::nullopt;
}

std::string SecondSolver::sum() const {
  std::vector<std::string> parts;
  if (opinion_.whole != 0)
    parts.push_back(fmt::format("{} statements, all of a proof at once", grouped(opinion_.whole)));
  if (opinion_.sampled != 0)
    parts.push_back(
        fmt::format("{} of {} statements, one by one", grouped(opinion_.asked), grouped(opinion_.sampled)));
  return parts.empty() ? program_ + " was not asked: nothing is proved"
                       : fmt::format("{} agrees: {}", program_, fmt::join(parts, "; "));
}

}  // namespace mmverify::cli
