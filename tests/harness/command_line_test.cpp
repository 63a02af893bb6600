// The commands list and solve, and the errors of the command line, tested by running the program.
#include <algorithm>
#include <cmath>

#include "meshes/formats/bytes.h"
#include "tests/harness/program.h"

namespace geodesic::harness {
namespace {

class CommandLine : public ProgramTest {
 protected:
  /// Runs a command, expects success and returns the JSON that it prints.
  nlohmann::json solve(const std::vector<std::string>& words) const {
    return json_of("solve", words);
  }
  nlohmann::json json_of(const std::string& command, std::vector<std::string> words) const {
    words.insert(words.begin(), command);
    const Output output = run(PROGRAM, words);
    EXPECT_EQ(output.code, 0) << output.err;
    return nlohmann::json::parse(output.out);
  }
};

// A linker must not drop a solver that registers itself.
TEST_F(CommandLine, ListHasTheSolversOfEveryFolder) {
  const Output list = run(PROGRAM, {"list", "--json"});
  ASSERT_EQ(list.code, 0) << list.err;
  std::vector<std::string> listed;
  const nlohmann::json printed = nlohmann::json::parse(list.out);
  for (const nlohmann::json& solver : printed.at("solvers")) {
    listed.push_back(solver.at("name"));
  }
  std::istringstream expected(SOLVER_NAMES);
  for (std::string pair; std::getline(expected, pair, ',');) {
    const std::string name = pair.substr(pair.find(':') + 1);
    EXPECT_EQ(std::count(listed.begin(), listed.end(), name), 1) << pair;
  }
  EXPECT_FALSE(listed.empty());
}

TEST_F(CommandLine, ListTellsWhichMeshesAreThere) {
  const Output list = run(PROGRAM, {"list", "--json"});
  const nlohmann::json meshes = nlohmann::json::parse(list.out).at("meshes");
  ASSERT_EQ(meshes.size(), 3u);
  EXPECT_EQ(meshes[0].at("cached"), true);
  EXPECT_EQ(meshes[2].at("cached"), false);
  EXPECT_EQ(run(PROGRAM, {"list", "--corpus", "missing"}).out.find("hill"), std::string::npos);
}

TEST_F(CommandLine, SolveWritesAJsonObjectAndDistancesInFileOrder) {
  const auto file = folder_ / "distances.txt";
  const nlohmann::json printed =
      solve({(folder_ / "tetrahedron.obj").string(), "--solver", exact_solver(), "--source", "0",
             "--output", file.string()});
  EXPECT_EQ(printed.at("solver"), exact_solver());
  EXPECT_EQ(printed.at("mesh"), "tetrahedron");
  EXPECT_EQ(printed.at("vertices"), 4);
  EXPECT_EQ(printed.at("faces"), 4);
  EXPECT_EQ(printed.at("sources"), nlohmann::json::array({0}));
  EXPECT_EQ(printed.at("unreachable_vertices"), 0);
  for (const char* key : {"cpu_time_s", "real_time_s", "prepare_time_s", "process_peak_bytes"}) {
    ASSERT_TRUE(printed.contains(key)) << key;
    EXPECT_TRUE(printed.at(key).is_number()) << key;
  }
  EXPECT_EQ(read(file), "0\n1\n1\n1\n");
}

// Counters need further solves.
TEST_F(CommandLine, SolveCountsWhenAskedAndNotOtherwise) {
  std::vector<std::string> words{"tetrahedron", "--solver", exact_solver(), "--source", "0"};
  const nlohmann::json plain = solve(words);
  words.push_back("--counters");
  const nlohmann::json counted = solve(words);
  for (const char* key : {"space_thesis_mb", "solver_peak_bytes", "window_propagations"}) {
    ASSERT_TRUE(counted.contains(key)) << key;
    EXPECT_TRUE(counted.at(key).is_number()) << key;
    EXPECT_FALSE(plain.contains(key)) << key;
  }
  for (const char* key : {"valid_windows", "window_limit", "peak_wavefront", "strip_depth",
                          "strip_b", "wavefront_sd"}) {
    EXPECT_TRUE(counted.contains(key)) << key << " is null where the solver has none, not absent";
  }
}

TEST_F(CommandLine, VectorInstructionsAreChosenByNameAndChangeNoDistance) {
  const auto instructions = [&](const std::string& vectors) {
    const auto file = folder_ / (vectors + ".txt");
    return solve({"hill", "--solver", exact_solver(), "--source", "1", "--vectors", vectors,
                  "--output", file.string()})
        .at("instruction_set")
        .get<std::string>();
  };
  EXPECT_EQ(instructions("plain"), "plain");
  const std::string widest = instructions("auto");
  EXPECT_EQ(read(folder_ / "plain.txt"), read(folder_ / "auto.txt"));
  if (widest != "plain") {
    EXPECT_EQ(instructions(widest), widest);
  }
}

TEST_F(CommandLine, SolvesOfEachSourceAreTheSameInAnyNumberOfThreads) {
  const std::vector<std::string> sources{"1", "36", "7", "7", "20", "2"};
  const auto solve_each = [&](const std::string& threads, const std::filesystem::path& file) {
    std::vector<std::string> words{"hill",      "--solver", exact_solver(), "--each",
                                   "--threads", threads,    "--output",     file.string()};
    for (const std::string& source : sources) words.insert(words.end(), {"--source", source});
    return solve(words);
  };
  const auto one = folder_ / "one.txt", three = folder_ / "three.txt";
  solve_each("1", one);
  const nlohmann::json printed = solve_each("3", three);
  EXPECT_EQ(read(one), read(three));
  EXPECT_EQ(printed.at("threads"), 3);
  ASSERT_EQ(printed.at("solves").size(), sources.size());

  std::istringstream lines(read(three));
  for (std::size_t i = 0; i < sources.size(); ++i) {
    EXPECT_EQ(printed.at("solves")[i].at("source").dump(), sources[i]);
    const auto alone = folder_ / "alone.txt";
    solve({"hill", "--solver", exact_solver(), "--source", sources[i], "--output", alone.string()});
    std::string expected = read(alone), line;
    std::replace(expected.begin(), expected.end(), '\n', ' ');
    expected.pop_back();
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line, expected) << "from vertex " << sources[i];
  }
}

TEST_F(CommandLine, SavedPreparationsGiveTheSameDistancesOnTheirMeshOnly) {
  const std::string file = folder_ / "prepared", made = folder_ / "made.txt",
                    read_again = folder_ / "read.txt";
  const nlohmann::json saved =
      solve({"hill", "--source", "1", "--solver", "straight-graph?alpha=0.5&check=2", "--output",
             made, "--save-prepared", file});
  const nlohmann::json printed = solve(
      {"hill", "--source", "1", "--source", "2", "--each", "--threads", "2", "--prepared", file});
  EXPECT_EQ(saved.at("certificate").at("sources"), 2);
  EXPECT_EQ(printed.at("certificate"), saved.at("certificate"));
  solve({"hill", "--source", "1", "--prepared", file, "--output", read_again});
  EXPECT_EQ(read(read_again), read(made));
  const Output refused =
      run(PROGRAM, {"solve", "tetrahedron", "--source", "1", "--prepared", file});
  EXPECT_EQ(refused.code, 1);
  EXPECT_EQ(refused.err,
            "geodesic-bench: --prepared " + file + ": the preparation is of another mesh\n");
}

TEST_F(CommandLine, ThreadsWithoutSeparateSourcesAreOfTheSolverThatCanUseThem) {
  std::vector<std::string> words{"hill", "--source", "1", "--threads", "2"};
  EXPECT_EQ(solve(words)["solver"], "edge-based?threads=2");
  words.insert(words.end(), {"--solver", "mmp", "--each"});
  EXPECT_EQ(solve(words)["solver"], "mmp");
}

TEST_F(CommandLine, OfSeveralMeshesTheOthersAreSolvedWhateverASolverThrows) {
  const Output output = run(
      kFaultyProgram, {"solve", "hill", "tetrahedron", "--solver", "throwing", "--source", "0"});
  EXPECT_EQ(output.code, 1);
  expect_words(output.err, {"hill: ran out of luck", "tetrahedron: ran out of luck",
                            "2 of 2 meshes were not solved"});
}

TEST_F(CommandLine, OneSourceOfManyThatIsNotThereIsAnErrorWithoutOutput) {
  const auto file = folder_ / "distances.txt";
  const Output refused =
      run(PROGRAM, {"solve", "hill", "--solver", exact_solver(), "--each", "--threads", "2",
                    "--source", "1", "--source", "37", "--source", "2", "--output", file.string()});
  EXPECT_EQ(refused.code, 1);
  expect_words(refused.err, {"--source 37: vertex 37 is not in the mesh of 37 vertices"});
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(CommandLine, SolveKeepsIsolatedVerticesAndEveryDigit) {
  const auto file = folder_ / "distances.txt";
  const nlohmann::json printed =
      solve({"hill", "--solver", exact_solver(), "--source", "1,36", "--output", file.string()});
  EXPECT_EQ(printed.at("unreachable_vertices"), 1);
  std::istringstream lines(read(file));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "inf");
  std::size_t count = 1;
  for (double distance = 0; std::getline(lines, line); ++count) {
    distance = std::stod(line);
    std::string again;
    append_text(again, distance);
    EXPECT_EQ(line, again);
  }
  EXPECT_EQ(count, 37u);
}

TEST_F(CommandLine, SolveLeavesFartherVerticesUnreachable) {
  const auto file = folder_ / "distances.txt";
  solve({"tetrahedron", "--solver", exact_solver(), "--source", "1", "--limit", "1.2", "--output",
         file.string()});
  EXPECT_EQ(read(file), "1\n0\ninf\ninf\n");
}

TEST_F(CommandLine, PointsMayBeWrittenInEveryFormAndPlace) {
  const std::string expected = R"([0,"edge:1-2:0.25","1+0.5"])";
  const auto sources = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"tetrahedron", "--solver", exact_solver()};
    all.insert(all.end(), words.begin(), words.end());
    return solve(all).at("sources").dump();
  };
  const auto in_file = [&](const std::string& text) {
    return sources({"--sources-file", write("points", text).string()});
  };
  EXPECT_EQ(sources({"--source", "0,edge:1-2:0.25,1+0.5"}), expected);
  EXPECT_EQ(sources({"--source", " 0, edge: 1 - 2 : 0.25 , 1 + 0.5 "}), expected);
  EXPECT_EQ(sources({"--source", "0", "--source", "edge:2-1:0.75", "--source", "1+0.5"}), expected);
  EXPECT_EQ(in_file("0 \"edge:1-2:0.25\"\n1+0.5\n"), expected);
  EXPECT_EQ(in_file("\xef\xbb\xbf"
                    "0,edge:1-2:0.25,1+0.5"),
            expected);
  EXPECT_EQ(in_file(R"([0, "edge:1-2:0.25", "1+0.5"])"), expected);
}

TEST_F(CommandLine, RowsOfThreeNumbersInFilesArePlacesUnlessTheyMayBeVertices) {
  const auto places = [&](const std::string& text) {
    const nlohmann::json printed = solve({"tetrahedron", "--solver", exact_solver(),
                                          "--sources-file", write("points", text).string()});
    nlohmann::json found = nlohmann::json::array();
    if (!printed.contains("places")) return printed.at("sources").dump();
    for (const auto& each : printed.at("places")) found.push_back(each.at("place"));
    return found.dump();
  };
  const std::string table = "[[0.0,0.5,0.0],[1.0,0.0,0.0]]";
  EXPECT_EQ(places("0,0.5,0\n1,0,0\n"), table);
  EXPECT_EQ(places("0\t5e-1 0\r\n\n\"1\" 0 0"), table);
  EXPECT_EQ(places("\"x\",\"y\",\"z\"\n0,0.5,0\n1,0,0\n"), table);
  EXPECT_EQ(places("[[0, 0.5, 0], [1, 0, 0]]"), table);
  EXPECT_EQ(places("[\"at:0,0.5,0\", [1.0, 0, 0], 3]"), table);
  EXPECT_EQ(places("x,y,z\n1,0,0\n"), "[[1.0,0.0,0.0]]");
  EXPECT_EQ(places("3\n0,0,-1\n"), "[[0.0,0.0,-1.0]]");
  EXPECT_EQ(places("1,2,0,3\n"), "[1,2,0,3]");
  EXPECT_EQ(places("1\n2\n0\n"), "[1,2,0]");
  EXPECT_EQ(places("[1, 2, 0]"), "[1,2,0]");
}

TEST_F(CommandLine, DistancesAtTargetsAreThoseOfThePointsWhateverTheSolverTakes) {
  for (const char* solver : {"mmp", "ich", "dijkstra"}) {
    const Output output =
        run(PROGRAM, {"solve", "tetrahedron", "--solver", solver, "--source", "edge:0-1:0.25",
                      "--target", "1,edge:0-1:0.75", "--target", "at:9,0,0"});
    ASSERT_EQ(output.code, 0) << output.err;
    const nlohmann::json printed = nlohmann::json::parse(output.out);
    const nlohmann::json& targets = printed.at("targets");
    EXPECT_EQ(targets[0].at("point"), 1);
    EXPECT_NEAR(targets[0].at("distance").get<double>(), 0.75, 1e-15);
    EXPECT_NEAR(targets[1].at("distance").get<double>(), 0.5, 1e-15);
    EXPECT_EQ(printed.at("places")[0].at("point"), targets[2].at("point").dump());
    EXPECT_GT(printed.at("places")[0].at("distance_to_surface").get<double>(), 7);
    expect_words(output.err, {"--target at:9,0,0 is ", " from the surface, whose nearest point"});
  }
}

TEST_F(CommandLine, TargetsOfSeparateSourcesAreInTheOrderInWhichTheyAreListed) {
  const nlohmann::json printed =
      solve({"tetrahedron", "--solver", "mmp", "--each", "--source", "0,edge:0-1:0.25", "--target",
             "edge:0-1:0.5,1", "--stop-at-targets"});
  EXPECT_EQ(printed.at("targets").dump(), R"(["edge:0-1:0.5",1])");
  const double expected[][2] = {{0.5, 1}, {0.25, 0.75}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto at_targets = printed.at("solves")[i].at("at_targets").get<std::vector<double>>();
    ASSERT_EQ(at_targets.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(at_targets[k], expected[i][k], 1e-15);
  }
}

TEST_F(CommandLine, SolvesToPointsAreCompared) {
  for (const char* solver : {"mmp", "ich"}) {
    const nlohmann::json printed =
        solve({"hill", "--solver", solver, "--source", "face:3:0.2,0.3,0.5,20+0.1", "--target",
               "face:9:0.3,0.3,0.4", "--check"});
    EXPECT_EQ(printed.at("reference"), "brute force");
  }
}

TEST_F(CommandLine, SolveWritesPathsAndTheNearestSources) {
  const auto distances = folder_ / "d.txt", paths = folder_ / "paths.json";
  solve({"tetrahedron", "--solver", "ich", "--source", "edge:0-1:0.25,2", "--target",
         "edge:0-1:0.5,2", "--paths", paths.string(), "--nearest-source", "--output",
         distances.string()});
  std::istringstream lines(read(distances));
  std::vector<int> nearest;
  for (double distance; lines >> distance;) lines >> nearest.emplace_back();
  EXPECT_EQ(nearest, (std::vector{0, 0, 1, 0}));
  const nlohmann::json traced = read_json(paths).at("paths");
  ASSERT_EQ(traced.size(), 2u);
  EXPECT_EQ(traced[0].at("source"), 0);
  EXPECT_NEAR(traced[0].at("length").get<double>(), 0.25, 1e-15);
  EXPECT_EQ(traced[1].at("length"), 0.0);
}

TEST_F(CommandLine, PathJoinsPointsAndClosesAndTraceGoesStraightOn) {
  const auto file = folder_ / "path.json";
  EXPECT_NEAR(json_of("path", {"tetrahedron", "--through", "1,0,2"}).at("length").get<double>(), 2,
              1e-15);
  const nlohmann::json loop =
      json_of("path", {"tetrahedron", "--through", "1,0,2", "--closed", "--output", file.string()});
  EXPECT_NEAR(loop.at("length").get<double>(), 2 + std::sqrt(2), 1e-15);
  EXPECT_EQ(read_json(file).at("paths").at(0).at("length"), loop.at("length"));
  const nlohmann::json line = json_of("trace", {"tetrahedron", "--from", "0", "--angle", "0",
                                                "--length", "0.25", "--output", file.string()});
  EXPECT_NEAR(line.at("length").get<double>(), 0.25, 1e-15);
  EXPECT_EQ(line.at("ends_at_boundary"), false);
  EXPECT_EQ(read_json(file).at("paths").at(0).at("points").back().at("position"), line.at("end"));
}

TEST_F(CommandLine, SolveWritesAnglesAndTheMeshWithItsDistances) {
  const auto table = folder_ / "polar.csv", mesh = folder_ / "field.ply";
  solve({"tetrahedron", "--source", "0", "--angles", "--output", table.string()});
  EXPECT_TRUE(read(table).starts_with("vertex,distance,angle\n0,0,0\n"));
  solve({"tetrahedron", "--source", "0", "--output", mesh.string()});
  EXPECT_NE(read(mesh).find("property double quality"), std::string::npos);
  const nlohmann::json again = solve({mesh.string(), "--source", "0"});
  EXPECT_EQ(again.at("vertices"), 4);
}

TEST_F(CommandLine, SolveWritesIsolinesOfEachLevel) {
  const auto file = folder_ / "lines.json";
  const nlohmann::json levels =
      solve({"tetrahedron", "--source", "0", "--isolines", file.string(), "--levels", "0.5,0.25"})
          .at("isolines");
  const nlohmann::json lines = read_json(file).at("isolines");
  ASSERT_EQ(levels.size(), 2u);
  ASSERT_EQ(lines.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(levels[i].at("level"), i == 0 ? 0.5 : 0.25);
    EXPECT_EQ(levels[i].at("lines"), 1);
    EXPECT_EQ(levels[i].at("closed"), 1);
    EXPECT_EQ(levels[i].at("length"), lines[i].at("length"));
    EXPECT_EQ(lines[i].at("level"), levels[i].at("level"));
  }
  const auto count_of = [&](const char* levels_of) {
    return solve(
               {"tetrahedron", "--source", "0", "--isolines", file.string(), "--levels", levels_of})
        .at("isolines")
        .size();
  };
  EXPECT_EQ(count_of("3"), 3u);
  EXPECT_EQ(count_of("3.0"), 1u);
}

TEST_F(CommandLine, SolveWritesPathsThatASolverTracesItself) {
  const auto file = folder_ / "paths.json";
  const nlohmann::json targets = solve({"hill", "--solver", "dijkstra", "--source", "7", "--target",
                                        "20,35", "--paths", file.string()})
                                     .at("targets");
  const nlohmann::json paths = read_json(file).at("paths");
  ASSERT_EQ(paths.size(), 2u);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    EXPECT_NEAR(paths[i].at("length").get<double>(), targets[i].at("distance").get<double>(),
                1e-14);
    for (const nlohmann::json& point : paths[i].at("points")) EXPECT_TRUE(point.contains("vertex"));
  }
}

TEST_F(CommandLine, DistancesOnStandardOutputLeaveTheJsonObjectToStandardError) {
  const Output solve = run(PROGRAM, {"solve", "tetrahedron", "--solver", exact_solver(), "--source",
                                     "0", "--output", "-"});
  ASSERT_EQ(solve.code, 0) << solve.err;
  EXPECT_EQ(solve.out, "0\n1\n1\n1\n");
  const std::string printed = solve.err.substr(solve.err.find("{\n"));  // after warnings
  EXPECT_EQ(nlohmann::json::parse(printed).at("vertices"), 4);
}

// Scripts, such as `check`, are Python modules of the data folder.
TEST_F(CommandLine, ScriptsAreCommandsWithTheirOwnHelpAndExitCode) {
  expect_words(run_plainly(PROGRAM, {"--help"}).out,
               {"compare", "rank", "report", "plot", "check"});
  const Output help = run_plainly(PROGRAM, {"check", "--help"});
  EXPECT_EQ(help.code, 0) << help.err;
  expect_words(help.out, {"usage: ", "[RUN]"});
  const Output refused = run_plainly(PROGRAM, {"check", "--nonsense"});
  EXPECT_NE(refused.code, 0);
  expect_words(refused.err, {"--nonsense"});
}

}  // namespace
}  // namespace geodesic::harness
