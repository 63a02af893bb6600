#include <gtest/gtest.h>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

TEST(UnknownName, ListsWhatExistsAndGuessesWhatWasMeant) {
  EXPECT_EQ(unknown_name("solver", "mpm", {"ch", "ich", "mmp"}),
            "no solver named 'mpm' (did you mean 'mmp'?); there are: ch, ich, mmp");
  EXPECT_EQ(unknown_name("solver", "dial", {"ch", "ich", "mmp"}),
            "no solver named 'dial'; there are: ch, ich, mmp");
  EXPECT_EQ(unknown_name("solver", "edge-base", {"ch", "edge-based"}),
            "no solver named 'edge-base' (did you mean 'edge-based'?); there are: ch, edge-based");
}

TEST(UnknownName, ListsTheNearestOfMany) {
  std::vector<std::string> known{"stanford-bunny"};
  for (int i = 0; i < 80; ++i) known.push_back("terrain-" + std::to_string(i));
  EXPECT_EQ(unknown_name("mesh", "terain-7", known),
            "no mesh named 'terain-7' (did you mean 'terrain-7'?); the nearest of 81: terrain-7, "
            "terrain-0, terrain-1, terrain-2, terrain-3, terrain-4, terrain-5, terrain-6");
}

TEST(UnknownName, SaysWhenThereIsNothing) {
  EXPECT_EQ(unknown_name("mesh", "horse", {}), "no mesh named 'horse'; there are: none");
}

TEST(UnknownName, ShowsALineWhateverTheNameIs) {
  const std::string huge = "\n\x1b[2J" + std::string(1'000'000, 'x');
  const std::string message = unknown_name("key", huge, {"corpus", "seed"});
  EXPECT_TRUE(message.starts_with("no key named '\\x0a\\x1b[2Jxxx")) << message.substr(0, 100);
  EXPECT_TRUE(message.ends_with("xxx...'; there are: corpus, seed"));
  EXPECT_LT(message.size(), 300u);
}

TEST(Excerpt, NeverCutsACharacterOfUtf8) {
  const std::string umlauts = [] {
    std::string text = "a";
    for (int i = 0; i < 150; ++i) text += "\u00fc";
    return text;
  }();
  EXPECT_EQ(excerpt(umlauts), umlauts.substr(0, 199) + "...");
  EXPECT_EQ(excerpt("f\u00fcr"), "f\u00fcr");
}

TEST(CheckName, TakesWhatAFileInAFolderCanBeCalled) {
  for (const char* name : {"bunny", "dragon-res2.ply", "A_1", "0"}) {
    EXPECT_NO_THROW(check_name("mesh", name)) << name;
  }
  const std::string long_one(101, 'a');
  for (const char* name : {"", ".", "..", "../a", "/a", "a/b", "a b", "a\n", ".hidden", "-o",
                           "\u00fc", long_one.c_str()}) {
    expect_error([&] { check_name("mesh", name); }, {"invalid mesh '"});
  }
}

TEST(Harmless, ShowsTextAsItIsAndEverythingElseAsItsBytes) {
  for (const char* text :
       {"", "plain", "Gr\u00fc\u00dfe", "\u30e1\u30c3\u30b7\u30e5", "\U0001f600"}) {
    EXPECT_EQ(harmless(text), text);
  }
  EXPECT_EQ(harmless("\x1b[2J\n\t\x7f"), R"(\x1b[2J\x0a\x09\x7f)");
  EXPECT_EQ(harmless(std::string_view("a\0b", 3)), R"(a\x00b)");
  EXPECT_EQ(harmless("\xc2\x9b"), R"(\xc2\x9b)") << "ESC [ in one character";
  EXPECT_EQ(harmless("\xc2\xa0"), "\xc2\xa0");
}

TEST(Harmless, LetsNoMalformedUtf8Pass) {
  EXPECT_EQ(harmless("a\xff"
                     "b\xc3"),
            R"(a\xffb\xc3)");
  EXPECT_EQ(harmless("\x80\xbf"), R"(\x80\xbf)");
  EXPECT_EQ(harmless("\xc0\xaf"), R"(\xc0\xaf)") << "a slash in two bytes";
  EXPECT_EQ(harmless("\xe0\x9f\xbf"), R"(\xe0\x9f\xbf)") << "too long";
  EXPECT_EQ(harmless("\xed\xa0\x80"), R"(\xed\xa0\x80)") << "a surrogate";
  EXPECT_EQ(harmless("\xf4\x90\x80\x80"), R"(\xf4\x90\x80\x80)") << "beyond Unicode";
  EXPECT_EQ(harmless("\xe3\x83"
                     "A"),
            R"(\xe3\x83A)")
      << "cut";
}

}  // namespace
}  // namespace geodesic::harness
