// The command verify, tested by running the program. The property that a fault breaks finds it, the
// saved case is small, and the printed command reproduces the failure.
#include <sys/wait.h>

#include <algorithm>
#include <fstream>

#include "tests/harness/program.h"

namespace geodesic::harness {
namespace {

class VerifyCommand : public ProgramTest {
 protected:
  std::filesystem::path out() const { return folder_ / "failures"; }

  Output verify(const std::string& solver, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"verify", "--solver", solver});
    arguments.insert(arguments.end(), {"--out", out().string()});
    return run(kFaultyProgram, arguments);
  }

  /// The rest of the line that begins with `word`.
  static std::string after(const std::string& word, const std::string& text) {
    const std::size_t at = text.find("\n  " + word);
    if (at == std::string::npos) return {};
    const std::size_t begin = text.find_first_not_of(' ', at + 3 + word.size());
    return text.substr(begin, text.find('\n', begin) - begin);
  }

  /// The meshes of saved cases.
  std::vector<std::filesystem::path> saved() const {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(out())) return files;
    for (const auto& entry : std::filesystem::directory_iterator(out())) {
      if (entry.path().extension() == ".obj") files.push_back(entry.path());
    }
    return files;
  }

  static std::size_t faces_of(const std::filesystem::path& file) {
    const std::string obj = '\n' + read(file);
    std::size_t faces = 0;
    for (std::size_t at = obj.find("\nf "); at != std::string::npos;
         at = obj.find("\nf ", at + 1)) {
      ++faces;
    }
    return faces;
  }
};

struct Fault {
  std::string solver;
  std::string property;          ///< that the fault breaks
  std::size_t least, most;       ///< limits of the saved mesh's faces
  std::string words;             ///< that the output contains
  std::string seconds = "60";    ///< time to shrink the case
  std::string time_limit = "2";  ///< of the property, in seconds
};

const std::string kApart = "another-component-is-infinitely-far";
const std::string kDistances = "distances-equal-the-reference";

std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.solver; }

class VerifyFinds : public VerifyCommand, public ::testing::WithParamInterface<Fault> {};

TEST_P(VerifyFinds, the_fault_by_the_property_that_it_breaks) {
  const Fault& fault = GetParam();
  const Output found = verify(fault.solver, {"--property", fault.property, "--time-limit",
                                             fault.time_limit, "--shrink", fault.seconds});
  EXPECT_EQ(found.code, 2) << found.err;
  EXPECT_EQ(found.err, "");
  expect_words(found.out, {"FAILS", fault.property, fault.solver + ": 0 hold, 1 fail"});
  expect_words(found.out, {fault.words});

  ASSERT_EQ(saved().size(), 1u) << found.out;
  EXPECT_TRUE(saved()[0].filename().string().starts_with(fault.property + "-on-")) << saved()[0];
  EXPECT_GE(faces_of(saved()[0]), fault.least);
  EXPECT_LE(faces_of(saved()[0]), fault.most);
  const std::string command = after("reproduce it", found.out);
  EXPECT_EQ(found.out.find("did not fail again"), std::string::npos) << found.out;
  const int status = std::system((command + " >/dev/null 2>&1").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2) << command;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, VerifyFinds,
    ::testing::Values(
        Fault{"wrong", "cone-distances-follow-from-the-angle-at-the-apex", 1, 3,
              "relative error 1e-09"},
        Fault{"boundary-blind", "square-with-hole-paths-bend-at-the-corners-of-the-hole", 1, 8,
              "boundary vertex\n    got       inf"},
        Fault{"single-minded", "source-in-each-component-reaches-both", 1, 2, ""},
        Fault{"forgetful", "distances-on-a-cube-equal-the-shortest-unfolding", 1, 8, ""},
        Fault{"forgetful", "repetition-gives-the-same-bits", 1, 10, "asked again"},
        Fault{"disturbed", "recordings-change-no-distance", 1, 3, ""},
        Fault{"not-a-number", kApart, 1, 2, "nan instead of"},
        Fault{"crashing", kApart, 1, 1, "killed by signal 6 (Aborted)"},
        Fault{"throwing", kApart, 1, 1, "threw: ran out of luck"},
        Fault{"leaving", kApart, 1, 1, "ended the process: exit code 0"},
        Fault{"looping", kApart, 1, 80, "did not end within 0.5 s", "4", "0.5"},
        Fault{"mute", kApart, 1, 80, "did not end within 0.5 s", "4", "0.5"},
        // Smaller meshes fail differently.
        Fault{"two-faced", kDistances, 6, 20, "relative error 1e-09"},
        Fault{"miscounting", "recordings-of-what-is-counted-are-positive-and-bounded", 1, 320,
              "strip_depth: expected at least 4, got 1"}),
    [](const auto& fault) {
      std::string name = fault.param.solver + "_by_" + fault.param.property;
      std::ranges::replace(name, '-', '_');
      return name;
    });

TEST_F(VerifyCommand, OfASoundSolverSaysThatAPropertyHolds) {
  const Output found = verify(exact_solver(), {"--property", "distances-equal-the-reference"});
  EXPECT_EQ(found.code, 0) << found.out << found.err;
  expect_words(found.out, {"holds        distances-equal-the-reference", ": 1 hold, 0 fail"});
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(VerifyCommand, WarnsOfASolverThatPropagatesFarMoreWindowsThanItsFamily) {
  if (run(kFaultyProgram, {"list"}).out.find("fwp-ch") == std::string::npos) {
    GTEST_SKIP() << "built without the family of Chen and Han";
  }
  const std::string warning = "times the windows of fwp-ch, of the same family";
  const std::vector<std::string> distances = {"--property", kDistances};
  const Output unordered = verify("ch", distances);
  EXPECT_EQ(unordered.code, 0) << unordered.err;
  EXPECT_NE(unordered.out.find("warning: ch propagates "), std::string::npos) << unordered.out;
  EXPECT_NE(unordered.out.find(warning), std::string::npos) << unordered.out;
  EXPECT_EQ(verify("ich", distances).out.find("warning"), std::string::npos);
}

TEST_F(VerifyCommand, DoesNotHoldAgainstASolverWhatItDoesNotClaim) {
  const Output found = verify("dijkstra", {"--property", "distances-are-symmetric"});
  EXPECT_EQ(found.code, 0) << found.out << found.err;
  expect_words(found.out, {"not promised", "dijkstra does not promise: exact distances"});
  const Output large = verify("tiny", {"--property", "distances-are-symmetric"});
  EXPECT_EQ(large.code, 0) << large.out << large.err;
  expect_words(large.out, {"not promised", "is limited to 3 vertices"});
}

// Vertex 0 of the hill is isolated: no limit separates its distances.
TEST_F(VerifyCommand, DoesNotCallHoldingWhatComparesNothing) {
  const Output found =
      verify("dijkstra", {"--property", "limit-keeps-what-is-nearer-and-drops-what-is-farther",
                          "--meshes", "hill", "--source", "0"});
  EXPECT_EQ(found.code, 0) << found.err;
  expect_words(found.out, {"not promised", "dijkstra has nothing to compare here",
                           "dijkstra: 0 hold, 0 fail, 1 not promised"});
}

TEST_F(VerifyCommand, AsksForDistancesOnMeshesOfTheUser) {
  const std::vector<std::string> on_hill = {"--property", "distances-equal-the-reference",
                                            "--meshes", "hill"};
  const Output sound = verify(exact_solver(), on_hill);
  EXPECT_EQ(sound.code, 0) << sound.out << sound.err;
  expect_words(sound.out, {"holds", "on hill"});
  const Output wrong = verify("wrong", on_hill);
  EXPECT_EQ(wrong.code, 2) << wrong.out << wrong.err;
  expect_words(wrong.out, {"FAILS", "on hill", "of the 37 and 50 of 'hill'"});
}

TEST_F(VerifyCommand, ChecksASavedCaseAgainAndExplainsIt) {
  const std::string property = "distances-equal-the-reference";
  verify("wrong", {"--property", property, "--meshes", "hill", "--source", "7"});
  ASSERT_EQ(saved().size(), 1u);
  std::filesystem::path file = saved()[0];
  file.replace_extension(".json");
  const Output again = run(kFaultyProgram, {"verify", "--file", file.string()});
  EXPECT_EQ(again.code, 2) << again.err;
  expect_words(again.out, {"FAILS", property, "first wrong: vertex ", "(brute force)"});
  const std::string bytes = read(file);
  const auto refused = [&](const std::string& text, const std::string& words) {
    std::ofstream(file) << text;
    const Output output = run(kFaultyProgram, {"verify", "--file", file.string()});
    EXPECT_EQ(output.code, 1) << text;
    expect_words(output.err, {file.string(), words});
  };
  const auto with = [&](std::string from, const std::string& to) {
    std::string text = bytes;
    return text.replace(text.find(from), from.size(), to);
  };
  refused("{", "not valid JSON");
  refused("{}", "no property named ''");
  refused(with("\"wrong\"", "3"), "no case that verify has saved");
  refused(with("\"vertex\": ", "\"vertex\": 9"), "is not in the mesh");
  refused(with("\"queries\": [", "\"queries\": [], \"unused\": ["), "no queries");
}

TEST_F(VerifyCommand, SavesMeshesOfOneNameInFilesOfTheirOwn) {
  std::vector<std::string> folders;
  for (const std::string folder : {"one", "other"}) {
    folders.push_back((folder_ / folder).string());
    std::filesystem::create_directory(folders.back());
    std::ofstream(folders.back() + "/mesh.obj")
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";
  }
  const Output found = verify("wrong", {"--property", "distances-equal-the-reference", "--source",
                                        "0", "--meshes", folders[0] + ',' + folders[1]});
  EXPECT_EQ(found.code, 2) << found.out << found.err;
  EXPECT_EQ(saved().size(), 2u) << found.out;
}

TEST_F(VerifyCommand, GivesUpOnASolverThatNeverEnds) {
  const Output found = verify("looping", {"--time-limit", "0.2", "--shrink", "0"});
  EXPECT_EQ(found.code, 2) << found.out << found.err;
  expect_words(found.out, {" 3 fail", "not checked, after 3 did not end", "--time-limit"});
}

TEST_F(VerifyCommand, OnRandomMeshesFindsEveryFaultAndGoesOnBehindCrashes) {
  const Output found = verify("boundary-blind,throwing,crashing,leaving,dijkstra",
                              {"--random", "12", "--jobs", "2", "--shrink", "5"});
  EXPECT_EQ(found.code, 2) << found.err;
  expect_words(found.out, {"FAILS        boundary-blind: distances-equal-the-reference on mesh ",
                           "FAILS        crashing: ", "ended the process: killed by signal 6",
                           "FAILS        leaving: ", "ended the process: exit code 0",
                           "FAILS        throwing: ", "threw: ran out of luck",
                           "--solver boundary-blind --random 1 --seed 1 --first ",
                           "meshes 0 to 11 of seed 1: ", "crashing: 0 hold, 12 fail",
                           "dijkstra: 12 hold, 0 fail"});
  ASSERT_EQ(saved().size(), 4u) << found.out;
  for (const auto& file : saved()) EXPECT_LE(faces_of(file), 4u) << file;
}

TEST_F(VerifyCommand, OnRandomMeshesGivesUpOnASolverThatNeverEnds) {
  const Output found =
      verify("looping,dijkstra", {"--random", "4", "--time-limit", "1", "--shrink", "0"});
  EXPECT_EQ(found.code, 2) << found.out << found.err;
  expect_words(found.out, {"did not end within 1 s", "dijkstra: 4 hold, 0 fail",
                           "looping: 0 hold, 3 fail, 0 not known, 1 not checked"});
}

TEST_F(VerifyCommand, OnRandomMeshesHoldsInexactSolversToWhatTheyPromise) {
  for (const auto& [solver, code] : {std::pair{"bounded?off=0.09", 0},
                                     {"bounded?off=0.11", 2},
                                     {"upper?off=0.5", 0},
                                     {"upper?off=-0.01", 2},
                                     {"unbounded?off=-0.5", 0}}) {
    const Output checked = verify(solver, {"--random", "2", "--shrink", "0"});
    EXPECT_EQ(checked.code, code) << solver << '\n' << checked.out << checked.err;
  }
}

TEST_F(VerifyCommand, OnACorpusSaysWhichMeshesAreNotThere) {
  const Output found =
      verify(exact_solver(), {"--property", "distances-equal-the-reference", "--corpus", "quick"});
  EXPECT_EQ(found.code, 1) << found.out << found.err;
  expect_words(found.out, {"on hill", "on tetrahedron", "not known", "datasets/fetch.py absent",
                           ": 2 hold, 0 fail", "1 not known"});
  expect_words(found.err, {"1 not known"});
}

TEST_F(VerifyCommand, InexactSolversAreHeldToWhatTheyPromise) {
  const auto code = [&](const std::string& solver, const std::string& property) {
    const Output verified = run(
        kFaultyProgram, {"verify", "--solver", solver, "--property", property, "--shrink", "0"});
    return std::pair(verified.code, verified.out);
  };
  for (const std::string property : {"distances-on-a-cube-equal-the-shortest-unfolding",
                                     "limit-keeps-what-is-nearer-and-drops-what-is-farther"}) {
    EXPECT_EQ(code("bounded?off=0.05", property).first, 0) << property;
    EXPECT_EQ(code("upper?off=0.5", property).first, 0) << property;
    EXPECT_EQ(code("unbounded?off=3", property).first, 0) << property;
  }
  const std::string cube = "distances-on-a-cube-equal-the-shortest-unfolding";
  EXPECT_EQ(code("bounded?off=0.2", cube).first, 2);
  EXPECT_EQ(code("upper?off=-0.01", cube).first, 2);
  const auto [skipped, why] = code("bounded", "distances-are-symmetric");
  EXPECT_EQ(skipped, 0);
  expect_words(why, {"not promised", "bounded does not promise: exact distances"});
}

TEST_F(VerifyCommand, ListsThePropertiesWithTheirStatements) {
  const Output list = run(PROGRAM, {"verify", "--list"});
  EXPECT_EQ(list.code, 0) << list.err;
  expect_words(list.out, {"refusals-name-the-solver\n    the message of a refused query",
                          "(needs a distance limit, initial distances, multiple sources)",
                          "are its edges (needs exact distances) (on its own meshes only)"});
}

// On this mesh CGAL 5.5 errs by 1e-5.
TEST_F(VerifyCommand, SolveCallsAnswersOnAFlatGridRightOrWrongAsTheyAre) {
  const std::string grid = (folder_ / "grid.obj").string();
  ASSERT_EQ(run_plainly(PROGRAM, {"generate", "grid", "--columns", "15", "--rows", "15",
                                  "--spacing", "0.1", "--diagonal", "forward", "-o", grid})
                .code,
            0);
  const auto check = [&](const std::string& solver) {
    return run(kFaultyProgram, {"solve", grid, "--solver", solver, "--source", "0", "--check"});
  };
  for (const char* solver : {"edge-based", "mmp", "ich", "dijkstra"}) {
    const Output sound = check(solver);
    EXPECT_EQ(sound.code, 0) << sound.err;
    EXPECT_NE(nlohmann::json::parse(sound.out).at("reference"), "cgal");
  }
  const Output wrong = check("wrong");
  EXPECT_EQ(wrong.code, 2) << wrong.out;
  expect_words(wrong.err, {"wrong: compared with ", "relative error 1e-09"});
}

TEST_F(VerifyCommand, SolveComparesDistancesWhenAsked) {
  const auto check = [&](const std::string& solver, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"solve",    "hill", "--solver", solver,
                                       "--source", "1",    "--check"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(kFaultyProgram, arguments);
  };
  const Output sound = check(exact_solver(), {});
  EXPECT_EQ(sound.code, 0) << sound.err;
  EXPECT_EQ(nlohmann::json::parse(sound.out).at("reference"), "brute force");
  const Output wrong = check("wrong", {});
  EXPECT_EQ(wrong.code, 2) << wrong.out;
  expect_words(wrong.err,
               {"wrong: compared with brute force", "first at vertex 36", "relative error 1e-09"});
  const Output each = check("forgetful", {"--source", "2", "--each"});
  EXPECT_EQ(each.code, 2) << each.out;
}

}  // namespace
}  // namespace geodesic::harness
