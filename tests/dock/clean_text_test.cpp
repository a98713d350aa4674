// Texts of subjects: what a terminal, a CI's log or JSON would trip over is written out, the rest stays.
#include "subjects/dock/clean_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using mmverify::dock::clean_lines;
using mmverify::dock::clean_text;

TEST(CleanText, KeepsWhatIsPlain) {
  for (const std::string text :
       {"", "no such triangle", "std::bad_alloc", "a#b", "u=0x1.8p-2 µ → 三角 𝛼", "\xf4\x8f\xbf\xbf"})
    EXPECT_EQ(clean_text(text), text);
}

TEST(CleanText, WritesOutWhatIsObeyed) {
  EXPECT_EQ(clean_text("a\nb\r\t\x1b[0m\x7f"), "a\\x0ab\\x0d\\x09\\x1b[0m\\x7f");
  EXPECT_EQ(clean_text(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(clean_text("\xc2\x9b"
                       "0m"),
            "\\xc2\\x9b0m")
      << "a control sequence in one character";
  EXPECT_EQ(clean_text("\xe2\x80\xa8\xe2\x80\xae\xe2\x81\xa6"),
            "\\xe2\\x80\\xa8\\xe2\\x80\\xae\\xe2\\x81\\xa6");
  EXPECT_EQ(clean_text("::error::x"), "\\x3a:error::x");
  EXPECT_EQ(clean_text("##[error] ###"), "#\\x23[error] #\\x23#");
}

TEST(CleanText, WritesOutWhatIsNoUtf8) {
  EXPECT_EQ(clean_text("a\xff"), "a\\xff");
  EXPECT_EQ(clean_text("\xe2\x82"), "\\xe2\\x82") << "cut within a character";
  EXPECT_EQ(clean_text("\xc0\xaf\xe0\x80\xaf"), "\\xc0\\xaf\\xe0\\x80\\xaf") << "longer than need be";
  EXPECT_EQ(clean_text("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half a pair of UTF-16";
  EXPECT_EQ(clean_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(CleanText, IsCleanOnce) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  for (const std::string& text : {all, std::string("::::"), std::string("####")})
    EXPECT_EQ(clean_text(clean_text(text)), clean_text(text));
}

TEST(CleanLines, AreLinesStill) {
  EXPECT_EQ(clean_lines("device: a\x1b\n::set-output\n"), "device: a\\x1b\n\\x3a:set-output\n");
}

}  // namespace
