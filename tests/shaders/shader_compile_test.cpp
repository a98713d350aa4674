// Shaders as subjects, up to the device: names, what a file defines, what is wrong with it, and places without a device.
#include <fstream>
#include <string>

#include "program/program.hpp"
#include "shaders/compile/compile.hpp"
#include "shaders/compile/sha256.hpp"
#include "shaders/compile/snippet.hpp"
#include "tests/dock/plugin.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;

std::string write(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return (folder / name).string();
}

Outcome judge(const std::string& subject, const std::string& more = "", const std::string& before = "") {
  return shell(before + " mmverify prove index.in_range --levels 0..1 --quiet --no-mutants --subject " +
               subject + " " + more);
}

constexpr const char* right = "uint index(uint level, float u, float v) { return 0u; }\n";

/// Compiling needs a compiler; `run test` installs it.
bool is_here(const std::vector<std::string>& words) {
  try {
    program::run_program(words);
    return true;
  } catch (const program::NoProgram&) {
    return false;
  }
}

class ShaderFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_here({"glslangValidator", "--version"}))
      GTEST_SKIP() << "no glslangValidator (Debian: glslang-tools)";
  }
  Folder folder_;
};

TEST(Sha256, is_that_of_fips_180_4) {
  // The standard's own examples, and one whose length needs a block more.
  EXPECT_EQ(shaders::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(shaders::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(shaders::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(ShaderName, has_an_entry_point_and_a_device) {
  EXPECT_FALSE(shaders::shader_name("mine.so"));
  EXPECT_FALSE(shaders::shader_name("step"));
  const auto plain = shaders::shader_name("a/b.comp");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->file, "a/b.comp");
  EXPECT_FALSE(plain->entry_point || plain->device);
  const auto full = shaders::shader_name("b.spv@corners@2");
  ASSERT_TRUE(full);
  EXPECT_EQ(full->entry_point, "corners");
  EXPECT_EQ(full->device, 2u);
  EXPECT_EQ(to_text(*full), "b.spv@corners@2");
}

TEST(SnippetFunctions, are_found_by_type_name_and_number_of_parameters) {
  const auto names = [](const std::string& text) {
    std::vector<std::string> all;
    for (const auto& f : shaders::functions_in(text)) all.emplace_back(f.entry_point);
    return all;
  };
  EXPECT_THAT(names("uint index(uint level, float u, float v) { return 0u; }"),
              testing::ElementsAre("index_f32"));
  EXPECT_THAT(names("uint  index ( uint level,\n float u, float v )\n{ return 0u; }"),
              testing::ElementsAre("index_f32"));
  EXPECT_THAT(names("uint index(uint level, float u, float v);"), testing::IsEmpty());  // a declaration
  EXPECT_THAT(names("int index(uint level, float u, float v) { return 0; }"), testing::IsEmpty());
  EXPECT_THAT(names("uint index(uint level, vec2 uv) { return 0u; }"), testing::IsEmpty());
  EXPECT_THAT(names("uint2 vertex_place(uint l, uint o, uint k) { return 0; } uint vq2_region(uint x, uint "
                    "y) { return 0u; }"),
              testing::ElementsAre("vq2_region", "attribute_vertex_place"));
}

TEST(Module, that_is_none_is_refused) {
  EXPECT_THROW(shaders::read_module("abc"), std::runtime_error);
  EXPECT_THROW(shaders::read_module(std::string(20, 'x')), std::runtime_error);
  // A header, then an instruction of 9 words of which 1 is there.
  const std::uint32_t words[] = {0x07230203, 0x00010300, 0, 1, 0, 9u << 16 | 129};
  EXPECT_THROW(shaders::read_module({reinterpret_cast<const char*>(words), sizeof words}),
               std::runtime_error);
}

TEST(Module, says_what_may_be_rearranged) {
  // %3 = OpFAdd, decorated; %4 = OpFMul and %5 = OpFSub, not; OpFNegate, which nothing rearranges.
  const std::uint32_t words[] = {0x07230203,
                                 0x00010300,
                                 0,
                                 9,
                                 0,
                                 3u << 16 | 71,
                                 3,
                                 42,
                                 5u << 16 | 54,
                                 1,
                                 2,
                                 0,
                                 1,
                                 5u << 16 | 129,
                                 1,
                                 3,
                                 6,
                                 7,
                                 5u << 16 | 133,
                                 1,
                                 4,
                                 6,
                                 7,
                                 5u << 16 | 131,
                                 1,
                                 5,
                                 6,
                                 7,
                                 4u << 16 | 127,
                                 1,
                                 8,
                                 6};
  const auto facts = shaders::read_module({reinterpret_cast<const char*>(words), sizeof words});
  EXPECT_EQ(facts.float_operations, 3u);
  EXPECT_EQ(facts.contractible, 2u);
  EXPECT_EQ(facts.contractible_in, std::vector<std::string>{"a function without a name"});
}

TEST_F(ShaderFile, that_does_not_compile_is_told_file_and_line) {
  const std::string file = write(
      folder_, "wrong.glsl",
      std::string("// one\n// two\n") + "uint index(uint level, float u, float v) {\n  return nothing;\n}\n");
  expect_complaint(judge(file), 2, "wrong.glsl:4: 'nothing' : undeclared identifier");
  const std::string hlsl =
      write(folder_, "wrong.hlsl", "\nuint index(uint level, float u, float v) { return nothing; }\n");
  expect_complaint(judge(hlsl), 2, "wrong.hlsl:2:");
  const std::string whole = write(folder_, "wrong.comp", "#version 450\nvoid main() {\n  oops;\n}\n");
  expect_complaint(judge(whole), 2, "wrong.comp:3:");
}

TEST_F(ShaderFile, that_defines_nothing_to_ask_is_refused) {
  expect_complaint(judge(write(folder_, "other.glsl", "float f() { return 1.0; }\n")), 2,
                   "neither main nor a function");
  const std::string whole =
      write(folder_, "whole.comp", "#version 450\nlayout(local_size_x = 64) in;\nvoid main() {}\n");
  expect_complaint(judge(whole, "--entry indices"), 2, "no entry point of shaders is called indices");
  const std::string flat =
      write(folder_, "flat.comp", "#version 450\nlayout(local_size_y = 64) in;\nvoid main() {}\n");
  expect_complaint(judge(flat), 2, "workgroup is not N x 1 x 1");
}

TEST_F(ShaderFile, that_includes_itself_is_given_up) {
  const std::string file =
      write(folder_, "self.glsl", "#include \"self.glsl\"\n#include \"self.glsl\"\n" + std::string(right));
  expect_complaint(judge(file), 2, "does the file include itself?");
}

TEST_F(ShaderFile, in_spirv_is_read_and_validated) {
  expect_complaint(judge(write(folder_, "text.spv", "no SPIR-V at all")), 2, "text.spv: no SPIR-V");
  expect_complaint(judge((folder_ / "missing.spv").string()), 4, "missing.spv: no such file");
  if (!is_here({"spirv-val", "--version"})) GTEST_SKIP() << "no spirv-val (Debian: spirv-tools)";
  // A header alone is a module, and a valid one has more.
  const std::uint32_t words[] = {0x07230203, 0x00010300, 0, 9, 0};
  const std::string header(reinterpret_cast<const char*>(words), sizeof words);
  expect_complaint(judge(write(folder_, "empty.spv", header)), 2, "empty.spv");
}

TEST_F(ShaderFile, in_slang_is_not_judged_where_no_compiler_is) {
  if (is_here({"slangc", "-v"})) GTEST_SKIP() << "slangc is here";
  const Outcome o = judge(write(folder_, "mine.slang", right));
  EXPECT_EQ(o.exit_code, 2) << o.err;
  EXPECT_THAT(o.out, HasSubstr("n/a        index.in_range"));
  EXPECT_THAT(o.out, HasSubstr("Slang is not available here: no slangc in PATH"));
  EXPECT_THAT(o.out, HasSubstr("https://github.com/shader-slang/slang/releases"));
}

TEST_F(ShaderFile, without_a_device_is_not_applicable) {
  const std::string file = write(folder_, "mine.glsl", right);
  const char* without = "VK_ICD_FILENAMES=/nowhere/icd.json";
  const Outcome o = judge(file, "", without);
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("n/a        index.in_range"));
  EXPECT_THAT(o.out, testing::AnyOf(HasSubstr("no Vulkan d"), HasSubstr("libvulkan-dev was not there")));
  // What else is asked is judged.
  const Outcome both = judge(file, "--subject step", without);
  EXPECT_EQ(both.exit_code, 0) << both.out << both.err;
  EXPECT_THAT(both.out, HasSubstr("proved     index.in_range"));
  EXPECT_THAT(both.out, HasSubstr("n/a        index.in_range"));
}

TEST_F(ShaderFile, of_ours_compiles_and_is_valid) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(MMVERIFY_SHADER_SUBJECTS)) {
    const shaders::Compiled made = shaders::compile({entry.path().string()});
    ++files;
    const bool plain = entry.path().stem().string().ends_with("_plain");
    EXPECT_EQ(made.warnings.empty(), !plain) << entry.path();
  }
  EXPECT_GE(files, 9u);
  // Figure 5 in the stage that it is written for.
  const std::string spirv = (folder_ / "figure_5.spv").string();
  const Outcome o =
      shell("cd " MMVERIFY_ROOT " && glslangValidator -I. -V --target-env vulkan1.2 -o " + spirv +
            " shaders/examples/figure_5.rchit && spirv-val --target-env vulkan1.2 " + spirv);
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

TEST_F(ShaderFile, options_of_shaders_need_one) {
  expect_complaint(judge("step", "--device 0"), 2, "no --subject is a shader");
}

}  // namespace
}  // namespace mmverify::tests
