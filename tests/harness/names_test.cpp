#include <gtest/gtest.h>

#include "harness/corpus/names.h"
#include "harness/error.h"
#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

TEST(UnknownName, ListsWhatExistsAndGuessesWhatWasMeant) {
  EXPECT_EQ(unknown_name("solver", "mpm", {"ch", "ich", "mmp"}),
            "no solver named 'mpm'; there are: ch, ich, mmp");
  EXPECT_EQ(unknown_name("solver", "edge-base", {"ch", "edge-based"}),
            "no solver named 'edge-base' (did you mean 'edge-based'?); there are: ch, edge-based");
}

TEST(UnknownName, SaysWhenThereIsNothing) {
  EXPECT_EQ(unknown_name("mesh", "horse", {}), "no mesh named 'horse'; there are: none");
}

TEST(UnknownName, ShowsALineWhateverTheNameIs) {
  const std::string huge = "\n\x1b[2J" + std::string(10'000'000, 'x');
  const std::string message = unknown_name("key", huge, {"corpus", "seed"});
  EXPECT_TRUE(message.starts_with("no key named '??[2Jxxx")) << message.substr(0, 100);
  EXPECT_TRUE(message.ends_with("xxx...'; there are: corpus, seed"));
  EXPECT_LT(message.size(), 300u);
}

TEST(Printable, NeverCutsACharacterOfUtf8) {
  const std::string umlauts = [] {
    std::string text = "a";
    for (int i = 0; i < 150; ++i) text += "\u00fc";
    return text;
  }();
  EXPECT_EQ(printable(umlauts), umlauts.substr(0, 199) + "...");
  EXPECT_EQ(printable("f\u00fcr"), "f\u00fcr");
}

TEST(CheckName, TakesWhatAFileInAFolderCanBeCalled) {
  for (const char* name : {"bunny", "dragon-res2.ply", "A_1", "0"}) {
    EXPECT_NO_THROW(check_name("mesh", name)) << name;
  }
  const std::string long_one(101, 'a');
  for (const char* name : {"", ".", "..", "../a", "/a", "a/b", "a b", "a\n", ".hidden", "-o",
                           "\u00fc", long_one.c_str()}) {
    expect_error([&] { check_name("mesh", name); }, {"no mesh can be named '"});
  }
}

}  // namespace
}  // namespace geodesic::harness
