#include "subjects/program/program.hpp"

namespace mmverify::program {

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) text.replace(at, 1, "; ");
  return text.empty() ? "it said nothing" : text;
}

}  // namespace mmverify::program
