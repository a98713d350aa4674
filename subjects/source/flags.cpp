#include "subjects/source/flags.hpp"

namespace mmverify::source {
namespace {

struct Refused {
  const char* begins;  ///< the flag, or how the flag begins if it ends with *
  const char* why;
};

constexpr const char* calls = "the compiler puts calls into functions, of which no statement speaks";
constexpr const char* other = "it changes the compiler in a way that nothing here follows";

constexpr Refused refused[] = {{"-pg", calls},
                               {"-p", calls},
                               {"--profile", calls},
                               {"-mfentry", calls},
                               {"-mrecord-mcount", calls},
                               {"-mnop-mcount", calls},
                               {"-finstrument-function*", calls},
                               {"-fpatchable-function-entry*", calls},
                               {"-fprofile*", calls},
                               {"-fcs-profile*", calls},
                               {"-fcoverage*", calls},
                               {"-fmemory-profile*", calls},
                               {"-fpseudo-probe-for-profiling", calls},
                               {"-ftest-coverage", calls},
                               {"-coverage", calls},
                               {"--coverage", calls},
                               {"-fsanitize*", calls},
                               {"-fxray*", calls},
                               {"-ftrap-function*", calls},
                               {"-ftrapv-handler*", calls},
                               {"-fsplit-stack", calls},
                               {"-fstack-check", calls},
                               {"-mstack-probe*", calls},
                               {"-ffixed-point",
                                "sums of fixed-point numbers that overflow are undefined, and "
                                "the bitcode does not say so"},
                               {"-mllvm", other},
                               {"-fplugin*", other},
                               {"-fpass-plugin*", other},
                               {"-load", other},
                               {"-plugin", other},
                               {"--config*", other},
                               {"@*", other}};

}  // namespace

std::optional<std::string> why_not_judged(const std::string& flag) {
  for (const Refused& one : refused) {
    std::string begins = one.begins;
    const bool is_beginning = begins.back() == '*';
    if (is_beginning) begins.pop_back();
    if (is_beginning ? flag.starts_with(begins) : flag == begins) return one.why;
  }
  return std::nullopt;
}

}  // namespace mmverify::source
