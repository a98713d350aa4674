// Writes the provers' statements, one folder a law: statement_files DIR.  ./run statements calls it.
#include <fmt/format.h>

#include <exception>

#include "tests/proofs/shipped_statements.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: statement_files DIR\n");
    return 2;
  }
  try {
    for (const auto& [path, statement] : mmverify::tests::shipped_statements())
      mmverify::tests::write(std::filesystem::path(argv[1]) / path, statement.text);
  } catch (const std::exception& error) {
    fmt::print(stderr, "statement_files: {}\n", error.what());
    return 4;
  }
  return 0;
}
