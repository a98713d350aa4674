// Shaders as subjects, up to the device: names, what a file defines, what is wrong with it, and places without a device.

#include <filesystem>
#include <fstream>
#include <string>

#include "subjects/program/program.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/compile/sha256.hpp"
#include "subjects/shaders/compile/snippet.hpp"
#include "subjects/shaders/compile/tools.hpp"
#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;

std::string write(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return (folder / name).string();
}

Outcome judge(const std::string& subject, const std::string& more = "", const std::string& before = "") {
  return shell(before +
               " mmverify prove index.in_range --levels 0..1 --details --quiet --no-mutants --subject " +
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

TEST(SnippetFunctions, take_arguments_in_the_order_of_the_text) {
  const auto arguments = [](const std::string& text) {
    const auto all = shaders::functions_in(text);
    return all.size() == 1 ? all[0].arguments : "no function, or several";
  };
  EXPECT_EQ(arguments("uint index(uint level, float u, float v) { return 0u; }"), "$level, IN0, IN1");
  EXPECT_EQ(arguments("uint index(float u, float v, uint level) { return 0u; }"), "IN0, IN1, $level");
  EXPECT_EQ(arguments("uint index(in float u, const uint level,\n highp float v) { return 0u; }"),
            "IN0, $level, IN1");
  EXPECT_EQ(arguments("uint tree_lookup_at(float u, float v, uint level, uint format) { return 0u; }"),
            "IN0, IN1, $level, $first");
  EXPECT_EQ(arguments("uint dag_lookup_at(float u, float v, uint f, uint m) { return 0u; }"),
            "uintBitsToFloat(IN1), uintBitsToFloat(IN2), $first, IN0");
  // Parameters of one type, outputs and other types keep the declared order.
  EXPECT_EQ(arguments("uint vq2_region(uint y, uint x) { return 0u; }"), "IN0, IN1");
  EXPECT_EQ(arguments("void corners(uint l, uint k, out uvec2 a, out uvec2 b, out uvec2 c) {}"),
            "$level, IN0");
  EXPECT_EQ(arguments("uint index(int level, float u, float v) { return 0u; }"), "$level, IN0, IN1");
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

TEST_F(ShaderFile, that_leaves_a_brace_open_is_named) {
  const std::string file =
      write(folder_, "open.glsl",
            "uint index(uint level, float u, float v) { if (u > 0.0) { return 1u; return 0u; }\n");
  expect_complaint(judge(file), 2, "open.glsl: after its end, in mmverify's own part:");
}

TEST_F(ShaderFile, may_begin_with_a_byte_order_mark) {
  const std::string file = write(
      folder_, "marked.glsl", "\xef\xbb\xbfuint index(uint level, float u, float v) { return nothing; }\n");
  expect_complaint(judge(file), 2, "marked.glsl:1: 'nothing' : undeclared identifier");
}

TEST_F(ShaderFile, that_is_a_folder_is_no_file) {
  const std::string folder = (folder_ / "folder.glsl").string();
  std::filesystem::create_directory(folder);
  expect_complaint(judge(folder), 4, "folder.glsl: a folder, pipe or device, and no file");
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

/// A whole shader that answers 0 to every index, and what else it declares and does.
std::string whole(const std::string& declares, const std::string& does = "", const std::string& size = "64") {
  return "#version 450\nlayout(local_size_x = " + size + R"() in;
layout(std430, set = 0, binding = 0) readonly buffer U { float u[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Out { uint answer[]; };
)" + declares +
         "\nvoid main() { uint k = gl_GlobalInvocationID.x; answer[k] = uint(u[k]) * 0u; " + does + " }\n";
}

TEST_F(ShaderFile, that_wants_what_nobody_gives_is_refused_by_name) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  if (!is_here({"spirv-cross", "--help"})) GTEST_SKIP() << "no spirv-cross (Debian: spirv-cross)";
  struct {
    const char *name, *declares, *does, *complaint;
  } const cases[] = {
      {"binding", "layout(set = 0, binding = 7) buffer Mine { uint more[]; };", "more[0] = 1u;",
       "binding.comp: index_f32: binding 7 of set 0 (`Mine`) is bound by nobody: there are bindings 0 to 4 "
       "of set 0"},
      {"set", "layout(set = 2, binding = 0) buffer Mine { uint more[]; };", "more[0] = 1u;",
       "set.comp: index_f32: binding 0 of set 2 (`Mine`) is bound by nobody"},
      {"uniform", "layout(set = 0, binding = 1) uniform Mine { uint more; };", "answer[k] = more;",
       "uniform.comp: index_f32: binding 1 of set 0 (`Mine`) is a uniform buffer, and what is bound are "
       "storage buffers"},
      {"texture", "layout(set = 0, binding = 2) uniform sampler2D mine;",
       "answer[k] = uint(textureLod(mine, vec2(0), 0).x);",
       "texture.comp: index_f32: binding 2 of set 0 (`mine`) is a sampled image"},
      {"image", "layout(set = 0, binding = 2, r32ui) uniform uimage2D mine;",
       "answer[k] = imageLoad(mine, ivec2(0)).x;", "binding 2 of set 0 (`mine`) is a storage image"},
      {"array", "layout(set = 0, binding = 1) buffer Mine { uint more[]; } mine[2];", "mine[1].more[0] = 1u;",
       "binding 1 of set 0 (`Mine`) is an array of storage buffers"},
      {"push", "layout(push_constant) uniform Asked { uint count, level, a, b, c; uvec2 d; };",
       "answer[k] = d.y;",
       "its push constants (`Asked`) take 32 bytes, and 20 are given: uint count, level, first, second, "
       "bytes"},
      {"nested", "struct S { uint a; uint b[4]; };\nlayout(push_constant) uniform Asked { uint n; S s; };",
       "answer[k] = s.b[3];", "take 24 bytes, and 20 are given"},
      {"size", "layout(local_size_x_id = 1) in;", "", "workgroup's size is a specialization constant"},
      {"atomics",
       "#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require\n#extension "
       "GL_EXT_shader_atomic_int64 : require\nlayout(set = 0, binding = 1) buffer Mine { uint64_t more; };",
       "atomicAdd(more, uint64_t(1));", "what no device is opened with, capability 12"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const std::string text = whole(c.declares, c.does);
    // An extension stands before all else.
    const auto extension = text.find("#extension"),
               end = text.find("\nlayout(set = 0, binding = 1) buffer Mine { uint64");
    const std::string ordered = extension == std::string::npos
                                    ? text
                                    : "#version 450\n" + text.substr(extension, end - extension) + "\n" +
                                          text.substr(13, extension - 13) + text.substr(end);
    const std::string file = write(folder_, std::string(c.name) + ".comp", ordered);
    const Outcome o = judge(file);
    expect_complaint(o, 2, c.complaint);
    EXPECT_EQ(o.out, "");
  }
  // A snippet has bindings of its own as well.
  expect_complaint(judge(write(folder_, "own.glsl",
                               "layout(set = 1, binding = 0) buffer Mine { uint more[]; };\n"
                               "uint index(uint level, float u, float v) { return more[0]; }\n")),
                   2, "own.glsl: index_f32: binding 0 of set 1 (`Mine`) is bound by nobody");
}

TEST_F(ShaderFile, that_answers_elsewhere_is_told_where) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  if (!is_here({"spirv-cross", "--help"})) GTEST_SKIP() << "no spirv-cross (Debian: spirv-cross)";
  const std::string elsewhere = R"(#version 450
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer U { float u[]; };
layout(std430, set = 0, binding = 2) buffer Out { uint answer[]; };
void main() { uint k = gl_GlobalInvocationID.x; answer[k] = uint(u[k]); }
)";
  expect_complaint(judge(write(folder_, "elsewhere.comp", elsewhere)), 2,
                   "elsewhere.comp: index_f32: it does not use binding 3 of set 0, where answers go; it may "
                   "write to binding 2 of set 0 (`Out`)");
}

TEST_F(ShaderFile, may_declare_what_it_does_not_use) {
  if (!is_here({"spirv-cross", "--help"}) || !is_here({"spirv-opt", "--version"}))
    GTEST_SKIP() << "no spirv-cross or spirv-opt";
  const std::string file = write(folder_, "unused.comp",
                                 whole("layout(set = 3, binding = 9) uniform sampler2D mine;\n"
                                       "float unused() { return textureLod(mine, vec2(0), 0).x; }"));
  EXPECT_EQ(shaders::compile({file}).warnings, std::vector<std::string>{});
}

TEST_F(ShaderFile, is_told_of_its_specialization_constants) {
  if (!is_here({"spirv-cross", "--help"})) GTEST_SKIP() << "no spirv-cross (Debian: spirv-cross)";
  const std::string file = write(folder_, "constant.comp",
                                 whole("layout(constant_id = 3) const uint side = 5;", "answer[k] = side;"));
  const auto warnings = shaders::compile({file}).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0],
              HasSubstr("constant.comp: index_f32: specialization constants are what the module gives them"));
  EXPECT_THAT(warnings[0], HasSubstr("3 (`side`): 5"));
}

TEST_F(ShaderFile, in_spirv_has_one_compute_shader_that_is_called) {
  const auto spirv = [&](const std::string& name, const std::string& text, const std::string& options) {
    const std::string source = write(folder_, name + ".glsl", text),
                      to = (folder_ / (name + ".spv")).string();
    const Outcome made =
        shell("glslangValidator -V --target-env vulkan1.1 " + options + " -o " + to + " " + source);
    EXPECT_EQ(made.exit_code, 0) << made.out << made.err;
    return to;
  };
  expect_complaint(judge(spirv("vertex", "#version 450\nvoid main() {}\n", "-S vert")), 2,
                   "vertex.spv: it has no compute shader; its entry points are main");
  // The name of an entry point is free.
  const std::string renamed = spirv("renamed", whole(""), "-S comp --source-entrypoint main -e other");
  EXPECT_EQ(shaders::compile({renamed}).manifest.modules.at(0).function, "other");
}

TEST_F(ShaderFile, is_asked_only_what_it_answers) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string file = write(folder_, "mine.glsl", right);
  expect_complaint(judge(file, "--entry nonsense"), 2,
                   "--entry: no entry point of shaders is called nonsense; there are index_f32, corners, ");
  expect_complaint(judge(file, "--entry Index"), 2, "no entry point of shaders is called Index");
  expect_complaint(judge(file + "@nonsense"), 2,
                   "mine.glsl: it does not answer nonsense; it answers index_f32");
  expect_complaint(judge(file, "--entry corners"), 2,
                   "mine.glsl: it does not answer corners; it answers index_f32");
  const std::string one = write(folder_, "whole.comp", whole(""));
  expect_complaint(judge(one + "@nonsense"), 2,
                   "whole.comp: no entry point of shaders is called nonsense; there are ");
  expect_complaint(judge("step", "--entry corners"), 2, "no --subject is a shader");
  const std::string both =
      write(folder_, "both.glsl",
            std::string(right) + "uint row_index(uint level, float u, float v) { return 0u; }\n");
  ASSERT_EQ(shaders::compile({both}).manifest.modules.size(), 2u);
  const auto chosen = shaders::compile({both, "row_index_f32"}).manifest.modules;
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen[0].entry_point, "row_index_f32");
}

TEST_F(ShaderFile, that_includes_itself_is_given_up) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
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

TEST_F(ShaderFile, in_slang_names_the_compiler_that_is_missing) {
  if (is_here({"slangc", "-v"})) GTEST_SKIP() << "slangc is here";
  const Outcome o = judge(write(folder_, "mine.slang", right));
  expect_complaint(o, 4, "mine.slang: no slangc in PATH, which compiles Slang");
  EXPECT_THAT(o.err, HasSubstr("https://github.com/shader-slang/slang/releases"));
}

TEST_F(ShaderFile, says_once_which_tool_is_missing) {
  const std::string file = write(folder_, "mine.glsl", right);
  expect_complaint(
      shell("PATH=/nowhere " MMVERIFY_PROGRAM " prove index.in_range --quiet --subject " + file), 4,
      "mine.glsl: no glslangValidator, which compiles GLSL and HLSL; install it (Debian: glslang-tools)");
}

TEST_F(ShaderFile, without_a_device_is_not_applicable) {
  const std::string file = write(folder_, "mine.glsl", right);
  const char* without = "VK_ICD_FILENAMES=/nowhere/icd.json";
  const Outcome o = judge(file, "", without);
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("n/a        index.in_range"));
  EXPECT_THAT(o.out, testing::AnyOf(HasSubstr("no Vulkan d"), HasSubstr("libvulkan-dev")));
  // Other subjects are still judged.
  const Outcome both = judge(file, "--subject step", without);
  EXPECT_EQ(both.exit_code, 0) << both.out << both.err;
  EXPECT_THAT(both.out, HasSubstr("proved     index.in_range"));
  EXPECT_THAT(both.out, HasSubstr("n/a        index.in_range"));
}

TEST_F(ShaderFile, of_ours_compiles_and_is_valid) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
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
      shell("cd " MMVERIFY_ROOT " && glslangValidator -Isubjects -V --target-env vulkan1.2 -o " + spirv +
            " subjects/shaders/examples/figure_5.rchit && spirv-val --target-env vulkan1.2 " + spirv);
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

TEST_F(ShaderFile, options_of_shaders_need_one) {
  expect_complaint(judge("step", "--device 0"), 2, "no --subject is a shader");
}

}  // namespace
}  // namespace mmverify::tests
