#include "cli/output/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "cli/output/json_text.hpp"
#include "cli/output/text.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name) = as_utf8(value).c_str();
}

void add_message(pugi::xml_node test, const char* kind, const std::string& message) {
  set(test.append_child(kind), "message", message);
}

struct Totals {
  int tests = 0, failures = 0, errors = 0, skipped = 0;
  double seconds = 0;
};

void add_test(pugi::xml_node suite, const Result& r, Totals& sums) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", r.law);
  set(test, "name",
      r.at_once.empty() ? fmt::format("{} level {}", r.subject, r.level)
                        : fmt::format("{} {}", r.subject, r.at_once));
  set(test, "time", fmt::format("{:.6f}", r.seconds));
  ++sums.tests;
  sums.seconds += r.seconds;
  switch (r.verdict) {
    case Verdict::refuted:
      ++sums.failures;
      add_message(test, "failure",
                  r.counterexamples.empty() ? "refuted" : counterexample_line(r, r.counterexamples.front()));
      break;
    case Verdict::broken:
      ++sums.failures;
      add_message(test, "failure", "broken: " + r.reason);
      break;
    case Verdict::incomplete:
      ++sums.errors;
      add_message(test, "error", "incomplete: " + r.reason);
      break;
    case Verdict::not_applicable:
      ++sums.skipped;
      add_message(test, "skipped", r.reason);
      break;
    case Verdict::proved:
    case Verdict::checked: break;
  }
}

/// Adds the properties of a suite, which come before its tests.
void add_properties(pugi::xml_node suite, const Report& report, const std::vector<RunsOn>& runs_on) {
  const std::string law = suite.attribute("name").value();
  pugi::xml_node properties;
  for (const RunsOn& one : runs_on) {
    const bool is_judged = std::any_of(report.results.begin(), report.results.end(), [&](const Result& r) {
      return r.law == law && (r.subject == one.subject || r.subject.starts_with(one.subject + ":"));
    });
    if (!is_judged) continue;
    if (!properties) properties = suite.append_child("properties");
    for (const auto& [key, value] : one.about) {
      pugi::xml_node property = properties.append_child("property");
      set(property, "name", fmt::format("{}: {}", one.subject, key));
      set(property, "value", value);
    }
  }
}

void set_sums(pugi::xml_node node, const Totals& sums) {
  set(node, "tests", fmt::format("{}", sums.tests));
  set(node, "failures", fmt::format("{}", sums.failures));
  set(node, "errors", fmt::format("{}", sums.errors));
  set(node, "skipped", fmt::format("{}", sums.skipped));
  set(node, "time", fmt::format("{:.6f}", sums.seconds));
}

}  // namespace

std::string to_junit(const Report& report, const std::vector<RunsOn>& runs_on) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites"), suite;
  Totals of_suite, of_all;
  const auto close_suite = [&] {
    if (suite) set_sums(suite, of_suite);
    of_all.tests += of_suite.tests;
    of_all.failures += of_suite.failures;
    of_all.errors += of_suite.errors;
    of_all.skipped += of_suite.skipped;
    of_all.seconds += of_suite.seconds;
    of_suite = {};
  };
  const auto in_suite = [&](const std::string& name) {
    if (suite && suite.attribute("name").value() == name) return;
    close_suite();
    suite = root.append_child("testsuite");
    set(suite, "name", name);
    add_properties(suite, report, runs_on);
  };
  for (const Result& r : report.results) {
    in_suite(r.law);
    add_test(suite, r, of_suite);
  }
  for (const MutantResult& m : report.mutants) {
    in_suite("mutants of " + m.law);
    pugi::xml_node test = suite.append_child("testcase");
    set(test, "classname", m.law);
    set(test, "name", "mutant: " + m.mutant);
    ++of_suite.tests;
    if (m.killed) continue;
    ++of_suite.failures;
    add_message(test, "failure", "the mutant survived: the law cannot fail on it");
  }
  close_suite();
  set(root, "name", "mmverify");
  set_sums(root, of_all);
  std::ostringstream out;
  document.save(out, " ");
  return out.str();
}

}  // namespace mmverify::cli
