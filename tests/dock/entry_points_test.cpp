// [sanitized, memory] The table of entry points beside the C header that it follows, read as text.
#include "subjects/dock/entry_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace mmverify::dock {
namespace {

struct Declared {
  std::string name, returned, parameters;
};

/// The pointers to functions of mmverify_subject_t, in their order.
std::vector<Declared> declared() {
  std::ifstream in(MMVERIFY_HEADER);
  std::stringstream text;
  text << in.rdbuf();
  std::string header = std::regex_replace(text.str(), std::regex(R"(/\*[^*]*\*+(?:[^/*][^*]*\*+)*/)"), " ");
  const auto from = header.find("typedef struct mmverify_subject {"),
             to = header.find("} mmverify_subject_t;");
  if (from == std::string::npos || to == std::string::npos) return {};
  header = header.substr(from, to - from);
  std::vector<Declared> all;
  const std::regex pointer(R"((\w+)\s*\(\s*\*(\w+)\s*\)\s*\(([^)]*)\)\s*;)");
  for (std::sregex_iterator it(header.begin(), header.end(), pointer), end; it != end; ++it)
    all.push_back({(*it)[2], (*it)[1], (*it)[3]});
  return all;
}

/// How often a type stands before a name or a comma in the parameters.
std::size_t count(const std::string& parameters, const std::string& type) {
  const std::regex one("(^|,)\\s*" + type + "\\s*\\*");
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(parameters.begin(), parameters.end(), one), std::sregex_iterator()));
}

TEST(EntryPoints, stand_in_the_headers_order) {
  std::vector<std::string> header, table;
  for (const Declared& d : declared()) header.push_back(d.name);
  for (const EntryPoint& e : entry_points) table.push_back(e.name);
  EXPECT_EQ(table, header);
  ASSERT_GE(header.size(), 24u);
  EXPECT_EQ(header.front(), "index_f32");
}

TEST(EntryPoints, take_what_the_header_declares) {
  const auto header = declared();
  ASSERT_EQ(header.size(), entry_points.size());
  for (std::size_t c = 0; c < calls; ++c) {
    const Signature& s = entry_points[c].signature;
    const std::string& p = header[c].parameters;
    const std::size_t floats = count(p, "const float"), doubles = count(p, "const double"),
                      words = count(p, "const uint32_t");
    EXPECT_EQ(s.arrays, floats + doubles + words) << header[c].name;
    EXPECT_EQ(s.number_bytes, doubles != 0 ? 8u : floats + words != 0 ? 4u : 0u) << header[c].name;
    EXPECT_EQ(s.of_blob, count(p, "const uint8_t") + count(p, R"(const mmverify_\w+_case_t)") != 0)
        << header[c].name;
    EXPECT_EQ(s.value_bytes, count(p, "uint32_t") + count(p, "float") != 0 ? 4u : 1u) << header[c].name;
    EXPECT_EQ(s.answers_floats, count(p, "float") != 0) << header[c].name;
    EXPECT_EQ(s.of_points, floats + doubles != 0) << header[c].name;
    EXPECT_EQ(s.sizes_answer, header[c].returned == "size_t") << header[c].name;
  }
}

// How many numbers one answer has: the header's types do not tell.
TEST(EntryPoints, numbers_of_an_answer) {
  const std::pair<const char*, std::size_t> several[] = {{"corners", 6},
                                                         {"row_corners", 6},
                                                         {"attribute_vertex_place", 2},
                                                         {"attribute_face_place", 3},
                                                         {"attribute_triplet", 3},
                                                         {"attribute_triplet_f32", 3},
                                                         {"attribute_weights_f32", 3},
                                                         {"attribute_decimate", 2},
                                                         {"array_resolve", 2},
                                                         {"subdivision_corners", 12}};
  for (const EntryPoint& e : entry_points) {
    std::size_t numbers = 1;
    for (const auto& [name, count] : several)
      if (std::string(e.name) == name) numbers = count;
    EXPECT_EQ(e.answer_bytes, numbers * e.signature.value_bytes) << e.name;
  }
}

TEST(EntryPoints, are_of_the_topic_that_their_name_begins_with) {
  const std::pair<const char*, Topic> known[] = {{"index", Topic::index},
                                                 {"tree", Topic::tree},
                                                 {"micromap", Topic::micromap},
                                                 {"vq", Topic::vq},
                                                 {"bake", Topic::bake},
                                                 {"attribute", Topic::attribute},
                                                 {"traverse", Topic::traverse},
                                                 {"array", Topic::array},
                                                 {"dag", Topic::dag}};
  const auto of_index = [](const std::string& name) {
    return name.starts_with("corners") || name.starts_with("row_");
  };
  for (const EntryPoint& e : entry_points) {
    const std::string name = e.name;
    for (const auto& [prefix, topic] : known) {
      EXPECT_EQ(e.topic == topic, name.starts_with(prefix) || (topic == Topic::index && of_index(name)))
          << name;
    }
  }
}

TEST(EntryPoints, have_their_place_for_a_number) {
  EXPECT_STREQ(entry_point(Call::index_f32).name, "index_f32");
  EXPECT_STREQ(entry_point(Call::tree_encode).name, "tree_encode");
  EXPECT_STREQ(entry_point(Call::bake).name, "bake");
  EXPECT_EQ(static_cast<std::size_t>(Call::bake), 23u);
}

}  // namespace
}  // namespace mmverify::dock
