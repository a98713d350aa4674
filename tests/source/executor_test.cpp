// [release] Verdicts of mmverify-codec on C programs: random ones beside their compiled selves, each undefined thing.
// MMVERIFY_FUZZ_SEEDS=N runs so many seeds in the place of six.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/folder.hpp"
#include "tests/source/random_buffers.hpp"

namespace mmverify {
namespace {

constexpr const char* declarations = R"(#include <stdint.h>
#include <stdlib.h>
#include <string.h>
uint64_t any(uint32_t bits);
void check(int holds);
void assume(int holds);
uint8_t* watched_memory(size_t size, const size_t* places, size_t count);
void only_read(const void* memory);
)";

// Memory of 16 bytes, of which byte `at`, any, is watched.
#define WATCHED "size_t at = any(4); uint8_t* m = watched_memory(16, &at, 1); m[at] = 7; "

class Executor : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string(MMVERIFY_CODEC).empty())
      GTEST_SKIP() << "no llvm-14-dev or no libcadical-dev: nothing to test";
  }

  /// The output of a shell command.
  std::string printed(const std::string& command) const {
    const auto out = folder_ / "out";
    EXPECT_EQ(std::system(fmt::format("( {} ) > {} 2>&1", command, out.string()).c_str()), 0)
        << command << "\n"
        << tests::text_of(out);
    return tests::text_of(out);
  }
  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  /// The answer for a law and, beside it, nothing: the law's file is all there is.
  std::string answer(const std::string& program, const std::string& more = {}) const {
    const std::string c = written("law.c", program), bc = c + ".bc", none = written("none.ll", "");
    printed(fmt::format(
        "clang -w -O1 -g -fno-discard-value-names -Xclang -disable-llvm-passes -emit-llvm -c -o {} {}", bc,
        c));
    return printed(fmt::format("{} {} {} law {}", MMVERIFY_CODEC, none, bc, more));
  }

  /// The answer for a law in C about f(), which is in C++.
  std::string answer_of_cpp(const std::string& f, const std::string& body,
                            const std::string& more = {}) const {
    constexpr const char* compiled =
        "clang{} -w -O1 -g -fno-discard-value-names -Xclang -disable-llvm-passes -emit-llvm -c -o {} {}";
    const std::string cpp = (folder_ / "f.cpp").string(),
                      c = written("law.c", fmt::format("{}int f(unsigned x);\nvoid law(void) {{ {} }}\n",
                                                       declarations, body));
    if (!std::filesystem::exists(cpp) || tests::text_of(cpp) != f)
      printed(fmt::format(compiled, "++ -std=c++20", cpp + ".bc", written("f.cpp", f)));
    printed(fmt::format(compiled, "", c + ".bc", c));
    return printed(fmt::format("{} {}.bc {}.bc law {}", MMVERIFY_CODEC, cpp, c, more));
  }
  /// The compiled program's values f(0), f(1), ... of a function in C++.
  std::vector<int> values_of_cpp(const std::string& f, unsigned count) const {
    const std::string cpp = written(
        "main.cpp", f + fmt::format("\n#include <cstdio>\nint main() {{ for (unsigned x = 0; x < {}; ++x) "
                                    "std::printf(\"%d\\n\", f(x)); }}\n",
                                    count));
    printed(fmt::format("clang++ -w -std=c++20 -O2 -o {0}.exe {0}", cpp));
    std::istringstream said(printed(cpp + ".exe"));
    std::vector<int> values;
    for (int v; said >> v;) values.push_back(v);
    return values;
  }

  tests::Folder folder_;
};

std::uint64_t seeds() {
  const char* n = std::getenv("MMVERIFY_FUZZ_SEEDS");
  return n == nullptr ? 6 : std::strtoull(n, nullptr, 10);
}

/// Pairs of numbers that a program runs on; a law chooses one of the eight.
std::vector<std::array<unsigned, 2>> some_pairs(std::uint64_t seed) {
  proofs::Random random(seed, 3, 0);
  std::vector<std::array<unsigned, 2>> pairs;
  for (unsigned k = 0; k < 8; ++k) pairs.push_back({random.code(), random.code()});
  return pairs;
}

class RandomPrograms : public Executor {
 protected:
  /// Results of the compiled program on the pairs.
  std::vector<std::uint64_t> results(const std::string& program, std::uint64_t seed) const {
    std::string text = program + "#include <stdio.h>\nint main(void) {\n";
    for (const auto& [x, y] : some_pairs(seed))
      text += fmt::format("  printf(\"%lu\\n\", run({}, {}));\n", x, y);
    const std::string c = written("native.c", text + "}\n"), exe = c + ".exe";
    printed(
        fmt::format("clang -w -O0 -fsanitize=undefined,address -fno-sanitize-recover=all -o {} {}", exe, c));
    std::istringstream in(printed("ASAN_OPTIONS=detect_leaks=0 " + exe));
    std::vector<std::uint64_t> all;
    for (std::uint64_t r = 0; in >> r;) all.push_back(r);
    return all;
  }
  /// A law that says so.
  static std::string law(const std::string& program, std::uint64_t seed,
                         const std::vector<std::uint64_t>& results) {
    std::string xs, ys, rs;
    const auto pairs = some_pairs(seed);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      xs += fmt::format("{}, ", pairs[k][0]);
      ys += fmt::format("{}, ", pairs[k][1]);
      rs += fmt::format("{}u, ", results[k]);
    }
    return fmt::format(
        "{}{}void law(void) {{\n  static const uint64_t x[] = {{{}}}, y[] = {{{}}}, r[] = {{{}}};\n"
        "  uint64_t k = any(3);\n  check(run(x[k], y[k]) == r[k]);\n}}\n",
        declarations, program, xs, ys, rs);
  }
};

TEST_F(RandomPrograms, GiveWhatTheirCompiledSelvesGive) {
  for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
    const std::string program = tests::RandomBuffers(seed).text();
    std::vector<std::uint64_t> due = results(program, seed);
    ASSERT_EQ(due.size(), some_pairs(seed).size()) << seed;
    const std::string said = answer(law(program, seed, due));
    EXPECT_NE(said.find("proved "), std::string::npos) << "seed " << seed << "\n" << said;
    // A wrong expectation is refuted, on that very pair.
    due[5] += 1;
    EXPECT_NE(answer(law(program, seed, due)).find("the check fails\nchoice 3 5\n"), std::string::npos)
        << seed;
  }
}

TEST_F(RandomPrograms, NoticeEachMistakeOfTheExecutor) {
  for (const char* mistake :
       {"signed-compare", "sign-lost", "shift-without-sign", "other-branch", "other-side", "bytes-reversed",
        "write-anywhere", "borrow-lost", "remainder-for-quotient", "copy-short", "shared-by-value"}) {
    bool noticed = false;
    for (std::uint64_t seed = 0; seed < 20 && !noticed; ++seed) {
      const std::string program = tests::RandomBuffers(seed).text();
      noticed = answer(law(program, seed, results(program, seed)), fmt::format("--plant {} || true", mistake))
                    .find("proved ") == std::string::npos;
    }
    EXPECT_TRUE(noticed) << mistake;
  }
}

/// A program that breaks one kind of obligation on some inputs, and the words that say so.
struct Undefined {
  const char *duty, *body, *says;
};

const std::array undefined{
    Undefined{"checks", "check(any(8) != 77);", "the check fails\nchoice 8 77\n"},
    Undefined{"bounds", "uint8_t b[5] = {0}; check(b[any(3)] == 0);", "a pointer outside of b"},
    Undefined{"bounds", "uint8_t b[4] = {0}; uint8_t* p = b + any(2); check(p[1] == 0);",
              "b is read outside of its 4 bytes"},
    Undefined{"bounds", "uint8_t b[4]; uint8_t* p = b + any(2); p[1] = 0;",
              "b is written outside of its 4 bytes"},
    Undefined{"bounds", "uint8_t b[5]; b[any(3)] = 1;", "a pointer outside of b"},
    Undefined{"bounds", "uint64_t n = any(2); uint8_t* p = calloc(n, 1); check(n == 0 || p[2] == 0);",
              "a pointer outside of the allocation"},
    Undefined{"bounds", "uint8_t b[4] = {0}, c[4]; memcpy(c, b, any(3));",
              "a copy of more bytes than there are"},
    Undefined{"pointers", "uint8_t b = 0; uint8_t* p = any(1) ? &b : 0; check(*p == 0);",
              "a null pointer is read"},
    Undefined{"pointers", "uint8_t* p = 0; p += any(1); check(p == 0);", "a null pointer moved"},
    Undefined{"bounds", "char t[3] = {1, (char)any(8), 1}; check(strlen(t) == 1);",
              "is read outside of its 3 bytes"},
    Undefined{"pointers", "uint8_t b[2], c[2]; uint8_t* p = any(1) ? b : c; check(p - b >= 0);",
              "the distance of pointers into different objects"},
    Undefined{"pointers", "uint8_t b[2], c[2]; check((any(1) ? b : c) <= b);",
              "the order of pointers into different objects"},
    Undefined{"life", "uint8_t* p = malloc(2); p[1] = 1; if (any(1)) free(p); check(p[1] == 1);",
              "after it was freed"},
    Undefined{"life", "uint8_t* p = malloc(2); if (any(1)) free(p); free(p);", "is freed after it was freed"},
    Undefined{"life", "static uint8_t b; free(any(1) ? &b : 0);", "is freed, which malloc did not return"},
    Undefined{
        "life",
        "const uint8_t* p; { uint8_t b[3] = {1}; p = b; } { uint8_t c = 2; check(c == 2); } check(*p == 1);",
        "b is read after its life"},
    Undefined{"life", "uint8_t* p; { uint8_t x = 1; p = &x; check(*p == 1); } *p = 2;",
              "x is written after its life"},
    Undefined{"unset", "uint8_t b[3]; b[0] = b[1] = 1; check(b[any(2) % 3] == 1);", "never set"},
    Undefined{"unset", "uint32_t n; if (any(4) != 9) n = 2; for (uint32_t k = 0; k < n; ++k) check(1);",
              "a branch on a value that was never set"},
    Undefined{"alignment", "uint8_t b[8] = {0}; uint16_t* p = (uint16_t*)(b + 2 * any(1)); check(*p == 0);",
              "b is read at an address that is no multiple of 2"},
    Undefined{"alignment", "uint64_t w[2] = {0}; uint32_t* p = (uint32_t*)((uint8_t*)w + any(3)); *p = 1;",
              "w is written at an address that is no multiple of 4"},
    Undefined{"alignment",
              "struct { uint64_t x; } a = {0}, *p = (void*)((uint8_t*)malloc(16) + any(3)); *p = a;",
              "is written at an address that is no multiple of 8"},
    Undefined{"shifts", "check((1u << any(6)) != 0);", "a shift by the width of the number or more"},
    Undefined{"overflow", "int x = (int)any(31); check(x + 1 > x);", "signed arithmetic overflows"},
    Undefined{"overflow", "int x = (int)any(20); check(x * 5000 >= 0);", "signed arithmetic overflows"},
    Undefined{"division", "check(7u / any(3) >= 1);", "a division by zero"},
    Undefined{"overlap", "uint8_t b[8] = {0}; memcpy(b + any(2), b, 3); check(b[0] == 0);",
              "memcpy between bytes that overlap"},
    Undefined{"constants", "static const uint8_t b[2] = {1, 2}; ((uint8_t*)b)[any(1)] = 3;", "the constant"},
    Undefined{"promises", "uint64_t n = any(3); __builtin_assume(n < 7); check(n < 8);", "promise"},
    Undefined{"ends", "if (any(9) == 300) abort();", "abort is called"},
    Undefined{"checks", WATCHED "size_t k = any(4); check(k == at || m[k] == m[(k + 1) % 16]);",
              "the check fails"},
    Undefined{"checks", WATCHED "size_t k = any(4); m[k] = 1; check(m[k] == 1);", "the check fails"},
    Undefined{"bounds", WATCHED "check(m[any(5)] < 256);", "a pointer outside of the memory"},
    Undefined{"bounds", WATCHED "memset(m + 12, 1, any(3));", "more bytes are set than there are"},
    Undefined{"bounds", WATCHED "uint8_t b[9] = {0}; memcpy(m + 9, b, any(4) % 10);",
              "a copy of more bytes than there are"},
    Undefined{"bounds", WATCHED "uint8_t b[9]; memcpy(b, m + 9, any(4) % 10);",
              "a copy of more bytes than there are"},
    Undefined{"constants", WATCHED "only_read(m); if (any(1)) m[3] = 1;", "the constant"},
    Undefined{"constants", WATCHED "only_read(m); memset(m, 1, 1 + any(1));", "the constant"},
    Undefined{"constants", WATCHED "uint8_t b[9] = {0}; only_read(m); memcpy(m, b, 9);", "the constant"},
    Undefined{"checks", "uint64_t x = any(3); check(!__builtin_constant_p(x));", "the check fails"},
    Undefined{"checks", "uint64_t x = any(3); check(__builtin_constant_p(x));", "the check fails"},
    Undefined{"ends", "if (any(9) == 300) __builtin_unreachable();",
              "code that is never reached is reached"}};

TEST_F(Executor, RefutesEachUndefinedThing) {
  for (const Undefined& one : undefined) {
    const std::string program = fmt::format("{}void law(void) {{ {} }}\n", declarations, one.body);
    const std::string said = answer(program);
    EXPECT_NE(said.find("refuted "), std::string::npos) << one.body << "\n" << said;
    EXPECT_NE(said.find(one.says), std::string::npos) << one.body << "\n" << said;
    // An executor that forgets this obligation does not say so.
    EXPECT_EQ(answer(program, fmt::format("--plant {}", one.duty)).find(one.says), std::string::npos)
        << one.body;
  }
}

TEST_F(Executor, ProvesWhatIsDefined) {
  for (const char* body :
       {"uint8_t b[5] = {0}; check(b[any(3) % 5] == 0);", "int x = (int)any(31); check(x - 1 < x);",
        "uint8_t* p = malloc(2); p[1] = 1; if (any(1)) { free(p); p = 0; } check(p == 0 || p[1] == 1); "
        "free(p);",
        "uint64_t n = any(6), s = 0; for (uint64_t k = 0; k < n; ++k) s += k; check(2 * s + n == n * n);",
        "uint64_t x = any(16); assume(x % 3 == 0); check(x != 65534 && x != 65533);",
        "uint64_t n = any(40); if (n < 9) { uint8_t* p = malloc(n + 1); p[n] = 1; check(p[n] == 1); free(p); "
        "}",
        "uint64_t w[2] = {0}; uint32_t* p = (uint32_t*)((uint8_t*)w + 4 * any(2)); check(*p == 0);",
        "char t[4] = {1, (char)any(8), (char)any(8), 0}; uint64_t n = strlen(t); check(n >= 1 && n <= 3 && "
        "!t[n]);",
        "uint8_t b[2], c[2]; uintptr_t x = (uintptr_t)(b + any(1)), y = (uintptr_t)c; check((x < y) == !(y < "
        "x));",
        "uint8_t b[9] = {0}; uint32_t x; memcpy(&x, b + any(2), 4); check(x == 0);",
        WATCHED "size_t k = any(4); m[k] = 1; check(m[at] == (k == at ? 1 : 7));",
        WATCHED "size_t n = any(2), k = any(3); memset(m + k, 1, n); "
                "check(m[at] == (at >= k && at < k + n ? 1 : 7));",
        WATCHED "uint8_t b[16]; for (int k = 0; k < 16; ++k) b[k] = k; size_t n = any(4); "
                "memcpy(m, b, n); check(m[at] == (at < n ? at : 7));",
        WATCHED "uint8_t b[8] = {0}; size_t n = any(3); memcpy(b, m, n); "
                "check(at >= 8 || b[at] == (at < n ? 7 : 0));",
        WATCHED "uint64_t w; size_t k = any(3); memcpy(&w, m + k, 8); "
                "check(at < k || at >= k + 8 || (w >> 8 * (at - k) & 255) == 7);",
        WATCHED "size_t p[2] = {at, at + any(1)}; uint8_t* o = watched_memory(32, p, 2); size_t n = any(4); "
                "o[at] = 5; memmove(o, m, n); check(o[at] == (at < n ? 7 : 5));",
        WATCHED "size_t p[2] = {at, any(4)}; uint8_t* o = watched_memory(16, p, 2); only_read(o); "
                "check(p[1] != at || o[at] == o[p[1]]);",
        "struct { uint8_t tag; uint32_t x; } a, b; a.x = (uint32_t)any(32); b = a; check(b.x == a.x);"}) {
    const std::string said = answer(fmt::format("{}void law(void) {{ {} }}\n", declarations, body));
    EXPECT_NE(said.find("proved "), std::string::npos) << body << "\n" << said;
  }
}

TEST_F(Executor, FollowsStructsInRegisters) {
  const std::string fours =
      std::string(declarations) +
      "typedef struct { uint32_t a, b, c, d; } four;\n"
      "static four made(uint32_t x) { four f = {1, x, x + 1, 0}; if (x == 9) f.d = 7; return f; }\n"
      "static int is(four f, uint32_t b, uint32_t c) { return f.b == b && f.c == c; }\n";
  const auto law = [&](const char* c) {
    return fours +
           "void law(void) { uint32_t x = (uint32_t)any(32); four f = made(x), g = f; check(is(g, x, " + c +
           ")); }\n";
  };
  EXPECT_NE(answer(law("x + 1")).find("proved "), std::string::npos);
  EXPECT_NE(answer(law("x + 2")).find("the check fails"), std::string::npos);
}

/// Throws at a number, at its own type, at a type of the standard library, or not; each path counts what it destroys.
constexpr const char* thrower = R"(#include <stdexcept>
#include <string>
#include <vector>
struct Counts { int* n; ~Counts() { ++*n; } };
struct Mine : std::runtime_error {
  int at;
  explicit Mine(int a) : std::runtime_error("mine"), at(a) {}
};
static void thrower(unsigned x, int* n) {
  const Counts one{n};
  std::vector<unsigned> some(x);
  if (x == 3) throw Mine(static_cast<int>(some.size()) + 4);
  try {
    const Counts two{n};
    if (x == 5) throw std::invalid_argument("five");
    if (x == 9) throw 4;
    if (x == 10) throw std::length_error("ten");
    if (x == 11) some.resize(~std::size_t{0});
  } catch (const std::length_error&) {
    *n += 50;
  } catch (...) {
    *n += 20;
    throw;
  }
}
extern "C" int f(unsigned x) {
  int n = 0;
  try {
    thrower(x, &n);
    return 100 + n;
  } catch (const Mine& mine) {
    return 200 + mine.at + n;
  } catch (const std::runtime_error&) {
    return 300;
  } catch (const std::logic_error&) {
    return 400 + n;
  }
#ifndef LEAVES
  catch (...) {
    return 500 + n;
  }
#endif
}
)";

TEST_F(Executor, FollowsExceptions) {
  constexpr unsigned bits = 4;
  const std::vector<int> values = values_of_cpp(thrower, 1U << bits);
  ASSERT_EQ(values.size(), 1U << bits);
  std::string law = "static const int due[] = {";
  for (const int v : values) law += std::to_string(v) + ",";
  law += "}; unsigned x = (unsigned)any(4); int is = f(x); ";
  EXPECT_NE(answer_of_cpp(thrower, law + "check(is == due[x]);").find("proved "), std::string::npos);
  for (const char* x : {"0", "3", "5", "9", "10", "11"})
    EXPECT_NE(answer_of_cpp(thrower, law + "check(is == due[x] && x != " + x + ");")
                  .find("choice 4 " + std::string(x)),
              std::string::npos)
        << x;
  const std::string said =
      answer_of_cpp("#define LEAVES\n" + std::string(thrower), law + "check(is == due[x]);");
  EXPECT_NE(said.find("f.cpp:17 leaves an entry point\nchoice 4 9\n"), std::string::npos) << said;
  EXPECT_EQ(answer_of_cpp("#define LEAVES\n" + std::string(thrower), law + "check(x == 9 || is == due[x]);",
                          "--plant ends")
                .find("leaves an entry point"),
            std::string::npos);
}

TEST_F(Executor, NamesExceptionsThatItCannotFollow) {
  for (const auto& [f, says] :
       {std::pair{
            "int n; struct E { ~E() { n = 1; } }; extern \"C\" int f(unsigned x) { try { if (x) throw E(); } "
            "catch (...) { return 1; } return 0; }",
            "an exception whose destructor does something"},
        std::pair{"struct A { int a; }; struct B { int b; }; struct E : A, B {}; extern \"C\" int f(unsigned "
                  "x) { try { "
                  "if (x) throw E(); } catch (const B&) { return 1; } return 0; }",
                  "an exception with several bases"}})
    EXPECT_NE(answer_of_cpp(f, "check(f((unsigned)any(1)) == 0);", "; test $? = 3").find(says),
              std::string::npos)
        << answer_of_cpp(f, "check(f((unsigned)any(1)) == 0);", "; test $? = 3");
}

TEST_F(Executor, MovesNullPointersByNothingInCpp) {
  const char* f =
      "#include <vector>\nextern \"C\" int f(unsigned x) { std::vector<unsigned char> v; if (x) "
      "v.push_back(1); "
      "int n = 0; for (unsigned char c : v) n += c; return n; }";
  EXPECT_NE(answer_of_cpp(f, "unsigned x = (unsigned)any(1); check(f(x) == (int)x);").find("proved "),
            std::string::npos);
}

TEST_F(Executor, RefusesALawThatSaysNothing) {
  const char* body = "uint64_t x = any(8); assume(x < 4); assume(x > 9); check(x == 77);";
  const std::string said =
      answer(fmt::format("{}void law(void) {{ {} }}\n", declarations, body), "|| test $? = 4");
  EXPECT_NE(said.find("the law's assumptions leave no input"), std::string::npos) << said;
}

TEST_F(Executor, GivesACodecNoWordOfTheLawsAndNoState) {
  const std::string counts = "extern \"C\" int mmverify_subject_v1() { static int calls; return ++calls; }\n";
  const std::string v1 = "int mmverify_subject_v1(void); ";
  EXPECT_NE(answer_of_cpp(counts + "extern \"C\" int f(unsigned) { return mmverify_subject_v1(); }\n",
                          "check(f(0) == 1);", "|| true")
                .find("calls, which outlives the call"),
            std::string::npos);
  EXPECT_NE(answer_of_cpp(counts + "extern \"C\" int f(unsigned) { return 0; }\n",
                          v1 + "mmverify_subject_v1(); mmverify_subject_v1(); check(f(0) == 0);", "|| true")
                .find("a later call of mmverify_subject_v1 changes"),
            std::string::npos);
  EXPECT_NE(answer_of_cpp(
                "extern \"C\" int mmverify_subject_v1() { static int filled; filled = 7; return filled; }\n"
                "extern \"C\" int f(unsigned) { return 0; }\n",
                v1 + "mmverify_subject_v1(); check(mmverify_subject_v1() == 7 && f(0) == 0);")
                .find("proved "),
            std::string::npos);
  EXPECT_NE(answer_of_cpp("extern \"C\" __attribute__((weak)) void assume(int);\n"
                          "extern \"C\" int f(unsigned x) { if (assume) assume(x != 3); return x == 3; }\n",
                          "check(f(any(3)) == 0);", "|| true")
                .find("it uses assume, which is a function of the laws"),
            std::string::npos);
}

// Inline functions of both are the codec's.
TEST_F(Executor, JudgesTheCodecsInlineFunctions) {
  const std::string law = written("law.ll", R"(declare void @check(i32)
define linkonce_odr i32 @g() {
  ret i32 1
}
define void @law() {
  %x = call i32 @g()
  %right = icmp eq i32 %x, 2
  %z = zext i1 %right to i32
  call void @check(i32 %z)
  ret void
}
)"),
                    codec = written("codec.ll", "define linkonce_odr i32 @g() {\n  ret i32 2\n}\n");
  EXPECT_NE(printed(fmt::format("{} {} {} law", MMVERIFY_CODEC, codec, law)).find("proved "),
            std::string::npos);
}

TEST_F(Executor, NamesWhatItCannotFollow) {
  for (const auto& [body, says] :
       {std::pair{"volatile float x = (float)any(3); check(x >= 0);", "law.c:9: the conversion uitofp"},
        std::pair{"check(atoi(\"7\") == 7);", "a call of strtol"},
        std::pair{"static int calls; check(++calls == 1);", "calls, which outlives the call"},
        std::pair{"static uint8_t b[2]; uint8_t c[2] = {1, 2}; memcpy(b, c, 2); check(b[0] == 1);",
                  "b, which outlives the call"},
        std::pair{"uint8_t b; check((uintptr_t)&b % 2 == 0);", "arithmetic on a pointer's bits"}})
    EXPECT_NE(
        answer(fmt::format("{}void law(void) {{ {} }}\n", declarations, body), "; test $? = 3").find(says),
        std::string::npos)
        << body;
}

}  // namespace
}  // namespace mmverify
