// Whole runs, with sound solvers and with faulty ones.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "tests/harness/run_test.h"
#include "tests/harness/whole_manifest.h"

namespace geodesic::harness {
namespace {

using nlohmann::json;

void expect_no_time(const json& row) {
  EXPECT_EQ(row.at("error_occurred"), true) << row;
  EXPECT_EQ(row.value("real_time", 0.0), 0.0) << row;
  EXPECT_EQ(row.value("cpu_time", 0.0), 0.0) << row;
  EXPECT_FALSE(row.contains("prepare_time")) << row;
}

TEST_F(RunTest, WithoutSolversEveryOneRunsThatNeedNotBeNamed) {
  std::vector<std::string> expected, by_name, ran;
  const json listed = json::parse(run(PROGRAM, {"list", "--json"}).out);
  for (const json& solver : listed.at("solvers")) {
    (solver.at("by_name_only") ? by_name : expected).push_back(solver.at("name"));
  }
  ASSERT_FALSE(by_name.empty());
  measure({"--meshes", "tetrahedron", "--sources", "1"});
  for (const json& each : rows()) {
    if (each.at("repetition_index") == 0) ran.push_back(each.at("solver"));
  }
  EXPECT_EQ(ran, expected);
}

TEST_F(RunTest, EveryRepetitionIsARowAndSolversAlternate) {
  const Output run =
      run_suite(PROGRAM, {"--solvers", exact_solver() + ",dijkstra", "--sources", "2"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, (out_ / "run.json").string() + "\n");
  std::vector<std::string> order;
  for (const json& each : rows()) {
    EXPECT_EQ(each.at("outcome"), "ok");
    EXPECT_EQ(each.at("time_unit"), "ms");
    EXPECT_EQ(each.at("run_type"), "iteration");
    EXPECT_GT(each.at("cpu_time").get<double>(), 0);
    EXPECT_TRUE(each.contains("reference"));
    if (each.at("repetition_index") == 0) order.push_back(each.at("solver"));
  }
  EXPECT_EQ(rows().size(), 2u * 2 * 2 * 2) << "meshes x sources x solvers x repetitions";
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(order[i], i % 2 == 0 ? exact_solver() : "dijkstra");
  }
}

TEST_F(RunTest, ContextSaysHowToTrustAndRepeatIt) {
  measure({"--solvers", "dijkstra", "--sources", "3", "--seed", "9"});
  const json context = run_context();
  EXPECT_EQ(context.at("schema_version"), 3);
  EXPECT_EQ(context.at("seed"), 9);
  EXPECT_EQ(context.at("repetitions"), 2);
  EXPECT_EQ(context.at("corpus"), "quick");
  EXPECT_EQ(context.at("sources").at("tetrahedron").size(), 3u);
  EXPECT_EQ(context.at("sources").at("tetrahedron")[0], 0);
  for (const json& source : context.at("sources").at("hill")) EXPECT_NE(source, 0) << "isolated";
  const json hill = context.at("meshes")[0];
  EXPECT_EQ(hill.at("name"), "hill");
  EXPECT_EQ(hill.at("file"), "hill.off");
  EXPECT_EQ(hill.at("vertices"), 37);
  EXPECT_EQ(hill.at("faces"), 50);
  EXPECT_EQ(hill.at("edges"), 85);
  EXPECT_EQ(hill.at("boundary_loops"), 1);
  EXPECT_EQ(hill.at("sha256").get<std::string>().size(), 64u);
  EXPECT_EQ(context.at("solvers")[0].at("name"), "dijkstra");
  ASSERT_EQ(context.at("skipped").size(), 1u);
  EXPECT_EQ(context.at("skipped")[0].at("mesh"), "absent");
}

TEST_F(RunTest, EveryCellHasAFileOfTheSameShape) {
  measure({"--solvers", "dijkstra", "--sources", "2"});
  std::size_t cells = 0;
  for (const auto& file : std::filesystem::directory_iterator(out_ / "cells")) {
    const json cell = read_json(file.path());
    EXPECT_EQ(cell.at("context").at("geodesic_bench").at("meshes").size(), 1u);
    EXPECT_EQ(cell.at("benchmarks").size(), 2u);
    ++cells;
  }
  EXPECT_EQ(cells, 4u);
  EXPECT_TRUE(std::filesystem::exists(out_ / "cells" / "dijkstra__tetrahedron__src0.json"));
}

TEST_F(RunTest, SourcesAndCountersAreTheSameAgain) {
  const auto counters = [&] {
    std::filesystem::remove_all(out_);
    const Output run = run_suite(PROGRAM, {"--solvers", exact_solver(), "--sources", "3"});
    EXPECT_EQ(run.code, 0) << run.err;
    json all = json::array();
    for (json row : rows()) {
      for (const char* key :
           {"real_time", "cpu_time", "iterations", "mesh_time", "prepare_time",
            "process_peak_bytes", "phase_seconds", "stolen_share", "involuntary_switches_per_s"}) {
        row.erase(key);
      }
      all.push_back(row);
    }
    return all;
  };
  EXPECT_EQ(counters(), counters());
}

TEST_F(RunTest, RowsTellTheVectorInstructionsThatRan) {
  measure({"--solvers", exact_solver() + ",dijkstra", "--sources", "1", "--meshes", "tetrahedron",
           "--vectors", "plain"});
  for (const json& each : rows()) EXPECT_EQ(each.at("instruction_set"), "plain") << each;
}

TEST_F(RunTest, RowsOfWindowSolversTellWhereTheTimeWent) {
  measure({"--solvers", exact_solver() + ",dijkstra", "--sources", "1", "--meshes", "hill"});
  for (const json& each : rows()) {
    if (each.at("solver") == "dijkstra") {
      EXPECT_FALSE(each.contains("phase_seconds")) << each;
      continue;
    }
    double sum = 0;
    for (const char* phase : {"propagation", "trimming", "queue", "timer_overhead"}) {
      EXPECT_GE(each.at("phase_seconds").at(phase).get<double>(), 0) << phase;
      sum += each.at("phase_seconds").at(phase).get<double>();
    }
    EXPECT_GT(sum, 0);
    EXPECT_EQ(each.at("phase_seconds").size(), 4u);
  }
}

// The data of a .npy file without its header, as bytes.
std::string npy_numbers(const std::string& file) {
  EXPECT_TRUE(file.starts_with("\x93NUMPY")) << file.substr(0, 80);
  return file.substr(file.find('\n') + 1);
}

TEST_F(RunTest, RecordedCellsLeaveTheWavefrontTheDistancesInexactOnesAndTheMesh) {
  write("an odd name.off", read(folder_ / "hill.off"));
  const std::string mesh = (folder_ / "an odd name.off").string();
  measure({"--solvers", exact_solver() + ",dijkstra", "--sources", "2", "--meshes", mesh,
           "--recordings", "all"});
  for (const json& each : rows()) {
    const std::string source = "recordings/an%20odd%20name/src" + each.at("source").dump();
    const auto folder = out_ / each.at("recordings").get<std::string>();
    const std::string exact = npy_numbers(read(out_ / source / "distances.npy"));
    EXPECT_EQ(exact.size(), 37u * 8);
    if (each.at("solver") == "dijkstra") {  // it has no wavefront of windows
      EXPECT_EQ(each.at("recordings"), source + "/dijkstra");
      const std::string inexact = npy_numbers(read(folder / "distances.npy"));
      EXPECT_EQ(inexact.size(), 37u * 8);
      EXPECT_NE(inexact, exact);
      EXPECT_FALSE(std::filesystem::exists(folder / "curve.npy"));
      continue;
    }
    EXPECT_EQ(each.at("recordings"), source + "/" + exact_solver());
    EXPECT_FALSE(std::filesystem::exists(folder / "distances.npy"));
    const std::size_t samples = npy_numbers(read(folder / "curve.npy")).size() / (4 + 8 + 3 * 8);
    EXPECT_GE(samples, 5u);
    for (const char* moment : {"25", "50", "75"}) {
      const std::string file = read(folder / ("snapshot-" + std::string(moment) + ".npy"));
      EXPECT_GE(npy_numbers(file).size(), 4u + 4 + 4 + 4 + 8) << moment;
    }
  }
  EXPECT_EQ(npy_numbers(read(out_ / "recordings/an%20odd%20name/vertices.npy")).size(), 37u * 12);
  EXPECT_EQ(npy_numbers(read(out_ / "recordings/an%20odd%20name/faces.npy")).size(), 50u * 12);
}

TEST_F(RunTest, FramesAreTheWavefrontAtEveryStepOfProgress) {
  measure({"--solvers", exact_solver(), "--sources", "1", "--meshes", "hill", "--recordings", "all",
           "--frames"});
  const auto folder = out_ / rows().at(0).at("recordings").get<std::string>();
  EXPECT_EQ(read(folder / "frame-32.npy"), read(folder / "snapshot-50.npy"));
  const std::string by = npy_numbers(read(folder / "reached_by.npy"));
  ASSERT_EQ(by.size(), 37u * 4);
  const std::size_t samples = npy_numbers(read(folder / "curve.npy")).size() / (4 + 8 + 3 * 8);
  for (std::size_t i = 0; i < by.size(); i += 4) {
    std::uint32_t sample = 0;
    std::memcpy(&sample, by.data() + i, 4);
    EXPECT_TRUE(sample < samples || sample == 0xffffffff) << sample;
  }
  for (int frame = 1; frame <= 60; ++frame) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("frame-" + std::to_string(frame) + ".npy")))
        << frame;
  }
}

template <class T>
std::vector<T> npy_vector(const std::string& file) {
  const std::string bytes = npy_numbers(file);
  std::vector<T> numbers(bytes.size() / sizeof(T));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(T));
  return numbers;
}

TEST_F(RunTest, RecordedPathsAreAsLongAsTheDistancesAndEverySourceIsInItsOwnCell) {
  measure({"--solvers", "mmp", "--sources", "1", "--meshes", "hill", "--recordings", "all"});
  const auto folder = (out_ / rows().at(0).at("recordings").get<std::string>()).parent_path();
  const auto distances = npy_vector<double>(read(folder / "distances.npy"));
  const auto points = npy_vector<float>(read(folder / "path_points.npy"));
  auto pieces = npy_vector<std::uint32_t>(read(folder / "path_pieces.npy"));  // target, first
  ASSERT_EQ(pieces.size(), 2u * 35)
      << "to every other vertex that is reached: one of 37 is isolated";
  pieces.insert(pieces.end(), {0, static_cast<std::uint32_t>(points.size() / 3)});
  for (std::size_t path = 0; path < 35; ++path) {
    double length = 0;
    for (std::size_t i = pieces[2 * path + 1] + 1; i < pieces[2 * path + 3]; ++i) {
      const float *from = &points[3 * (i - 1)], *to = &points[3 * i];
      length += std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    }
    const double distance = distances.at(pieces[2 * path]);
    EXPECT_NEAR(length, distance, 1e-5 * distance) << "target " << pieces[2 * path];
  }

  const auto sources = npy_vector<std::uint32_t>(read(folder / "cell_sources.npy"));
  const auto nearest = npy_vector<std::uint32_t>(read(folder / "cells.npy"));
  ASSERT_EQ(sources.size(), 8u);
  ASSERT_EQ(nearest.size(), 37u);
  EXPECT_EQ(rows().at(0).at("source"), sources.front());
  for (std::uint32_t i = 0; i < sources.size(); ++i) EXPECT_EQ(nearest[sources[i]], i);
  const auto of_a_source = [](std::uint32_t i) { return i < 8; };
  EXPECT_EQ(std::ranges::count_if(nearest, of_a_source), 36);
  EXPECT_EQ(std::ranges::count(nearest, 0xFFFFFFFF), 1) << "the isolated vertex";
}

TEST_F(RunTest, SetsOfSourcesAreCellsLikeSingleVertices) {
  const auto own = write("own.json", "[3, 7, 9]");
  measure({"--solvers", exact_solver() + ",dijkstra", "--sources", "1", "--meshes", "hill",
           "--source-sets", "random:3,boundary,components," + own.string(), "--recordings", "all"});
  json sources = json::array();
  for (const json& each : rows()) {
    EXPECT_EQ(each.at("outcome"), "ok") << each;
    const bool first = each.at("repetition_index") == 0 && each.at("solver") == "dijkstra";
    if (first) sources.push_back(each.at("source"));
  }
  const json context = run_context();
  EXPECT_EQ(sources, context.at("sources").at("hill"));
  EXPECT_EQ(sources.size(), 5u);
  const json sets = context.at("source_sets").at("hill");
  EXPECT_EQ(sets.at("random:3").at("vertices"), 3);
  EXPECT_EQ(sets.at("own").at("vertices"), 3);
  EXPECT_EQ(read_json(out_ / sets.at("own").at("file").get<std::string>()), json({3, 7, 9}));
  const json cell = read_json(out_ / "cells" / "dijkstra__hill__srcown.json").at("context");
  EXPECT_EQ(cell.at("geodesic_bench").at("source_sets"),
            json({{"hill", {{"own", sets.at("own")}}}}));
  const json set = row(exact_solver() + "/hill/src:own");
  const auto folder = (out_ / set.at("recordings").get<std::string>()).parent_path();
  EXPECT_EQ(npy_vector<std::uint32_t>(read(folder / "cell_sources.npy")),
            (std::vector<std::uint32_t>{3, 7, 9}));
  const auto distances = npy_vector<double>(read(folder / "distances.npy"));
  for (const std::size_t v : {3u, 7u, 9u}) EXPECT_EQ(distances[v], 0) << v;
}

TEST_F(RunTest, PathsAreMeasuredOfSolversThatHaveThemFromSingleVertices) {
  measure({"--solvers", "edge-based,dijkstra,flip-out,virtual-source", "--sources", "1", "--meshes",
           "hill", "--source-sets", "random:3", "--path-targets", "10"});
  const std::string cell = "/hill/src:" + rows().at(0).at("source").dump();
  for (const json& each : rows()) {
    const bool has_paths = each.at("solver") != "virtual-source" && each.at("source").is_number();
    EXPECT_EQ(each.contains("paths"), has_paths) << each;
  }
  const auto number = [&](const std::string& solver, const char* key) {
    return row(solver + cell).at("paths").at(key).get<double>();
  };
  for (const char* solver : {"edge-based", "dijkstra", "flip-out"}) {
    EXPECT_EQ(number(solver, "targets"), 10);
    EXPECT_EQ(number(solver, "off_surface"), 0);
    EXPECT_EQ(number(solver, "failed"), 0);
    for (const char* time : {"alone_time", "first_time", "further_time"}) {
      EXPECT_GT(number(solver, time), 0) << solver << ' ' << time;
    }
  }
  EXPECT_EQ(number("edge-based", "shortest"), 10);
  EXPECT_LT(number("edge-based", "max_excess"), 1e-12);
  EXPECT_LT(number("dijkstra", "shortest"), 10);
  EXPECT_GT(number("dijkstra", "mean_excess"), number("flip-out", "mean_excess"));
}

TEST_F(RunTest, FurtherSourcesAreSolvedInTheFirstCellOfAMeshAndComparedWhereNotExact) {
  measure({"--solvers", exact_solver() + ",dijkstra", "--sources", "2", "--meshes", "hill",
           "--further-sources", "5"});
  const std::string first = rows().at(0).at("source").dump();
  for (const json& each : rows()) {
    const bool is_first = each.at("source").dump() == first;
    ASSERT_EQ(each.contains("further"), is_first) << each;
    EXPECT_EQ(each.contains("further_errors"), is_first && each.at("solver") == "dijkstra");
    if (!is_first) continue;
    EXPECT_EQ(each.at("further").at("sources"), 5);
    EXPECT_GT(each.at("further").at("time"), 0);
    EXPECT_GT(each.at("further").at("pair_time"), 0);
  }
  const json errors = row("dijkstra/hill/src:" + first).at("further_errors");
  EXPECT_NE(errors.at("reference"), "dijkstra");
  EXPECT_GT(errors.at("mean"), 0);
  EXPECT_GT(errors.at("max"), errors.at("mean"));
  EXPECT_LE(errors.at("pair_max"), errors.at("max"));
  EXPECT_GT(errors.at("pair_max"), errors.at("pair_mean"));
}

TEST_F(RunTest, ErrorsOfFurtherSourcesAreThoseOfTheSolver) {
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "upper?off=0.5", "--sources", "1", "--meshes",
                                 "tetrahedron", "--further-sources", "100"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json of_all = rows().at(0);
  EXPECT_EQ(of_all.at("further").at("sources"), 4);  // the mesh has no more vertices
  const json errors = of_all.at("further_errors");
  EXPECT_NEAR(errors.at("mean"), 0.375, 1e-12);  // of four vertices, the source has none
  for (const char* each : {"max", "pair_mean", "pair_max"})
    EXPECT_NEAR(errors.at(each), 0.5, 1e-12);
}

TEST_F(RunTest, AWrongAnswerFromAFurtherSourceLeavesNoTime) {
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "stale-bound", "--sources", "1", "--meshes",
                                 "tetrahedron", "--further-sources", "4"});
  EXPECT_EQ(run.code, 2) << run.err;
  const json wrong = rows().at(0);
  expect_words(message(wrong), {"from further source ", "relative error 1e-09"});
  expect_no_time(wrong);
}

TEST_F(RunTest, AMeshWithoutAnySourceIsSkippedBeforeTheFirstCellWithTheReason) {
  const Output run = run_suite(PROGRAM, {"--solvers", "dijkstra", "--sources", "0", "--meshes",
                                         "hill,tetrahedron", "--source-sets", "boundary"});
  expect_words(run.err, {"skipped tetrahedron: no vertex is a source (boundary)"});
  EXPECT_LT(run.err.find("skipped tetrahedron"), run.err.find("[1/2]")) << run.err;
  EXPECT_EQ(rows().size(), 2u);
}

TEST_F(RunTest, SmallMeshesAndRunsWithoutRecordingsLeaveNone) {
  for (const char* choice : {"auto", "none"}) {
    std::filesystem::remove_all(out_);
    const Output run =
        run_suite(PROGRAM, {"--solvers", exact_solver(), "--sources", "1", "--recordings", choice});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(std::filesystem::exists(out_ / "recordings")) << choice;
    for (const json& each : rows()) EXPECT_FALSE(each.contains("recordings")) << choice;
  }
}

// The folder of the recordings cannot be written, as on a full disk.
TEST_F(RunTest, RecordingsThatCannotBeWrittenCostNoTime) {
  std::filesystem::create_directories(out_);
  write("out/recordings", "in the way");
  const Output run = run_suite(PROGRAM, {"--solvers", exact_solver(), "--sources", "1", "--meshes",
                                         "hill", "--recordings", "all"});
  EXPECT_EQ(run.code, 1) << run.err;
  expect_words(run.err, {"not recorded: cannot make the folder"});
  for (const json& each : rows()) {
    EXPECT_EQ(each.at("outcome"), "ok");
    EXPECT_GT(each.at("cpu_time").get<double>(), 0);
    EXPECT_FALSE(each.contains("recordings"));
    EXPECT_NE(each.at("recordings_error").get<std::string>().find("recordings"), std::string::npos);
  }
}

TEST_F(RunTest, ReferencesComputedInThreadsAreThoseOfARunWithout) {
  const auto references = [&](const std::string& threads) {
    std::filesystem::remove_all(out_);
    const Output run = run_suite(PROGRAM, {"--solvers", exact_solver() + ",dijkstra", "--sources",
                                           "4", "--threads", threads});
    EXPECT_EQ(run.code, 0) << run.err;
    std::map<std::string, std::string> files;
    for (const auto& file : std::filesystem::directory_iterator(out_ / "references")) {
      files[file.path().filename().string()] = read(file.path());
    }
    return files;
  };
  const auto one = references("1");
  EXPECT_GE(one.size(), 8u) << "meshes x sources";
  EXPECT_EQ(references("3"), one);
}

TEST_F(RunTest, FailedReferencesInThreadsHarmNoOtherCell) {
  const Output run = run_suite(
      kFaultyProgram, {"--solvers", "crashing,dijkstra", "--meshes", "tetrahedron", "--sources",
                       "3", "--reference", exact_solver(), "--threads", "2"});
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_EQ(row("crashing/tetrahedron/src:0").at("outcome"), "crashed");
  EXPECT_EQ(row("dijkstra/tetrahedron/src:0").at("outcome"), "ok");
}

TEST_F(RunTest, FlagsOverrideTheSuite) {
  const auto suite = write("suite.json", R"({"corpus": "missing", "sources": 3, "seed": 5})");
  measure({suite.string(), "--meshes", "tetrahedron", "--sources", "1", "--solvers", "dijkstra"});
  const json context = run_context();
  EXPECT_EQ(context.at("sources"), json({{"tetrahedron", {0}}}));
  EXPECT_EQ(context.at("seed"), 5);
  EXPECT_EQ(context.at("corpus"), "chosen");
}

TEST_F(RunTest, ACorpusBringsTheOptionsOfTheSuiteOfItsNameAndNoneToASuiteThatIsNamed) {
  const std::string own = write("own.json", R"({"solvers": ["dijkstra"]})").string();
  const auto solvers = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--corpus", "frontier", "--plan"});
    return json::parse(run_plainly(PROGRAM, words).out).at("solvers").get<int>();
  };
  EXPECT_EQ(solvers({"run", own}), 1);
  EXPECT_GT(solvers({"run"}), 10) << "the suite names the values of parameters";
}

TEST_F(RunTest, AFileWithTheNameOfAnotherMeshOfTheManifestIsWarnedOf) {
  std::filesystem::create_directories(folder_ / "own");
  const std::string file = write("own/hill.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
  const Output other = run_suite(PROGRAM, {"--solvers", "dijkstra", "--meshes", file});
  EXPECT_EQ(other.code, 0) << other.err;
  expect_words(other.err, {"warning: ", "is not the mesh 'hill'", "rename it"});
  std::filesystem::remove_all(out_);
  const Output same = run_suite(PROGRAM, {"--solvers", "dijkstra", "--meshes", "hill"});
  EXPECT_EQ(same.err.find("warning"), std::string::npos) << same.err;
}

TEST_F(RunTest, TakesMeshesByFolderPatternFileAndName) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* file : {"b.obj", "a.OBJ", "notes.txt", "deep/c.obj"}) {
    std::filesystem::create_directories((folder_ / "scans" / file).parent_path());
    write(std::string("scans/") + file, triangle);
  }
  const std::string scans = (folder_ / "scans").string();
  measure({"--solvers", "dijkstra", "--sources", "1", "--meshes",
           scans + "/," + scans + "/*/c.*,hill"});
  const json context = run_context();
  std::vector<std::string> names;
  for (const json& mesh : context.at("meshes")) names.push_back(mesh.at("name"));
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "c", "hill"}));
}

TEST_F(RunTest, PassesFlagsOnToGoogleBenchmark) {
  const auto run_with = [&](const std::string& flag) {
    std::filesystem::remove_all(out_);
    return run(PROGRAM, {"run", "--solvers", "dijkstra", "--meshes", "hill", "--sources", "1",
                         "--out", out_.string(), "--", flag});
  };
  EXPECT_EQ(run_with("--benchmark_min_time=0.0001").code, 0);
  const auto few = rows()[0].at("iterations").get<int>();
  EXPECT_EQ(run_with("--benchmark_min_time=0.1").code, 0);
  EXPECT_GT(rows()[0].at("iterations").get<int>(), few);
  for (const char* refused :
       {"--benchmark_out=x", "--benchmark_nonsense", "--benchmark_filter=x"}) {
    EXPECT_EQ(run_with(refused).code, 1) << refused;
  }
}

TEST_F(RunTest, ARunIsNeverOverwritten) {
  std::filesystem::create_directories(out_ / "cells");
  const Output run = run_suite(PROGRAM, {"--solvers", "dijkstra"});
  EXPECT_EQ(run.code, 1);
  expect_words(run.err, {"holds a run already"});
}

TEST_F(RunTest, WrongAnswersGetNoTimeAndNameTheVertex) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "wrong," + exact_solver(), "--meshes",
                                                "hill", "--sources", "1"});
  EXPECT_EQ(run.code, 2) << run.err;
  const std::string source = rows()[0].at("source").dump();
  const json wrong = row("wrong/hill/src:" + source);
  EXPECT_EQ(wrong.at("outcome"), "wrong answer");
  expect_no_time(wrong);
  expect_words(message(wrong), {"first at vertex 36", "relative error 1e-09"});
  EXPECT_EQ(row(exact_solver() + "/hill/src:" + source).at("outcome"), "ok");
  expect_words(run.err, {"wrong/hill/src:" + source + ": wrong answer"});
}

TEST_F(RunTest, WrongAnswersKeepTheSizesOfTheirErrors) {
  run_suite(kFaultyProgram, {"--solvers", "wrong", "--meshes", "tetrahedron", "--sources", "1"});
  const json wrong = row("wrong/tetrahedron/src:0");  // one of four distances
  const auto size = [&](const char* key) { return wrong.value(key, -1.0); };
  EXPECT_NEAR(size("max_relative_error"), 1e-9, 1e-12);
  EXPECT_NEAR(size("p99_relative_error"), 1e-9, 1e-12);
  EXPECT_NEAR(size("mean_relative_error"), 1e-9 / 4, 1e-12);
  EXPECT_NEAR(size("rms_relative_error"), 1e-9 / 2, 1e-12);
  EXPECT_EQ(wrong.at("unreachable_mismatches"), 0);
  EXPECT_FALSE(wrong.at("reference").get<std::string>().empty());
}

TEST_F(RunTest, SolversAreJudgedByWhatTheyPromiseWithTheParametersOfTheirNames) {
  const std::string solvers =
      "bounded?off=0.05,0.2,bounded?bound=0.50&off=0.2,upper?off=2.0,-0.25,"
      "unbounded?threads=3&off=-0.5";
  const Output run = run_suite(kFaultyProgram,
                               {"--solvers", solvers, "--meshes", "tetrahedron", "--sources", "1"});
  EXPECT_EQ(run.code, 2) << run.err;
  const std::map<std::string, std::pair<std::string, double>> expected{
      {"bounded?off=0.05", {"ok", 0.05}},          {"bounded?off=0.2", {"wrong answer", 0.2}},
      {"bounded?off=0.2&bound=0.5", {"ok", 0.2}},  {"upper?off=2", {"ok", 2}},
      {"upper?off=-0.25", {"wrong answer", 0.25}}, {"unbounded?off=-0.5&threads=3", {"ok", 0.5}}};
  for (const auto& [solver, what] : expected) {
    const json each = row(solver + "/tetrahedron/src:0");
    EXPECT_EQ(each.value("outcome", ""), what.first) << each;
    EXPECT_NEAR(each.value("max_relative_error", 0.0), what.second, 1e-12) << each;
    EXPECT_EQ(each.value("threads", 0), solver.ends_with("threads=3") ? 3 : 1) << each;
  }
  EXPECT_TRUE(std::filesystem::exists(out_ / "cells" /
                                      "bounded%3Foff%3D0.2%26bound%3D0.5__tetrahedron__src0.json"));
  const json described = run_context();
  EXPECT_EQ(described.at("solvers")[2].at("error_bound"), 0.5);
  EXPECT_EQ(described.at("solvers")[2].at("values").at("off"), 0.2);
}

TEST_F(RunTest, AParameterThatIsWrongIsOneLineBeforeAnythingRuns) {
  for (const auto& [solver, words] : {std::pair{"bounded?of=1", "did you mean 'off'?"},
                                      {"bounded?off=99", "a number from -0.5 to 10"},
                                      {"bonded?off=1", "did you mean 'bounded'?"},
                                      {"dijkstra?off=1", "there are: none"},
                                      {"bounded?off=1,bounded?off=1.0", "named twice"},
                                      {"bounded?off=0.1,0.2&bound=0.5", "comes last"},
                                      {"bounded?off=0.1,far", "no solver named 'far'"},
                                      {"dijkstra,7", "no solver named '7'"}}) {
    const Output run = run_suite(kFaultyProgram, {"--solvers", solver});
    EXPECT_EQ(run.code, 1);
    expect_words(run.err, {words});
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(out_));
  }
}

TEST_F(RunTest, WhatASolverPrintsReachesNoResult) {
  const Output run = run_suite(
      kFaultyProgram, {"--solvers", "printing", "--meshes", "tetrahedron", "--sources", "1"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(row("printing/tetrahedron/src:0").at("outcome"), "ok");
  for (const std::string& text : {run.out, run.err, read(out_ / "run.json")}) {
    EXPECT_EQ(text.find("forged"), std::string::npos) << text;
  }
}

TEST_F(RunTest, RenewalComesBeforeEverySolveAndIsTimedApart) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "renewable,dijkstra", "--meshes",
                                                "tetrahedron", "--sources", "1"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Json renewable = row("renewable/tetrahedron/src:0");
  EXPECT_GE(renewable.at("renew_time").get<double>(), 10);
  EXPECT_LT(renewable.at("cpu_time").get<double>(), renewable.at("renew_time").get<double>())
      << "the time of a solve contains that of its renewal";
  EXPECT_FALSE(row("dijkstra/tetrahedron/src:0").contains("renew_time"));
}

TEST_F(RunTest, EverySolveOfASolverThatIsNotDeterministicMustKeepThePromise) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "fickle,fickle?by=1e-3", "--meshes",
                                                "tetrahedron", "--sources", "1"});
  EXPECT_EQ(run.code, 2) << run.err;
  EXPECT_EQ(row("fickle/tetrahedron/src:0").at("outcome"), "ok") << rows();
  EXPECT_EQ(row("fickle?by=0.001/tetrahedron/src:0").at("outcome"), "wrong answer") << rows();
}

TEST_F(RunTest, ASolveThatDiffersFromTheVerifiedOneIsWrong) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "forgetful,disturbed", "--meshes",
                                                "tetrahedron", "--sources", "1"});
  EXPECT_EQ(run.code, 2) << run.err;
  for (const char* solver : {"forgetful", "disturbed"}) {
    const json spoiled = row(std::string(solver) + "/tetrahedron/src:0");
    EXPECT_EQ(spoiled.at("outcome"), "wrong answer");
    expect_words(message(spoiled), {"other distances"});
    expect_no_time(spoiled);
  }
}

TEST_F(RunTest, OtherSourcesMustNotShowInAnAnswer) {
  const auto suite = write("suite.json", R"({"solvers": ["stale", "dijkstra"],
      "other_queries": 2, "meshes": ["tetrahedron"], "sources": 1})");
  EXPECT_EQ(run_suite(kFaultyProgram, {suite.string()}).code, 2);
  const json spoiled = row("stale/tetrahedron/src:0");
  EXPECT_EQ(message(spoiled), "after 2 other sources the same object gave other distances");
  expect_no_time(spoiled);
  EXPECT_EQ(row("dijkstra/tetrahedron/src:0").at("outcome"), "ok");
}

TEST_F(RunTest, FailingCellsLeaveRowsAndHarmNoOther) {
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "crashing,throwing,leaving,exiting,tiny,dijkstra",
                                 "--meshes", "tetrahedron", "--sources", "1"});
  EXPECT_EQ(run.code, 1) << run.err;
  const std::map<std::string, std::pair<std::string, std::string>> expected{
      {"crashing", {"crashed", "killed by signal 6"}},
      {"throwing", {"error", "ran out of luck"}},
      {"leaving", {"error", "without writing a result"}},
      {"exiting", {"error", "without writing a result"}},
      {"tiny", {"unsupported", "limited to 3 vertices"}}};
  for (const auto& [solver, what] : expected) {
    const json failed = row(solver + "/tetrahedron/src:0");
    EXPECT_EQ(failed.at("outcome"), what.first);
    expect_words(message(failed), {what.second});
    expect_no_time(failed);
  }
  EXPECT_EQ(row("dijkstra/tetrahedron/src:0").at("outcome"), "ok");
}

TEST_F(RunTest, UnsupportedMeshesAreCountedAndNoFailures) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "tiny,dijkstra", "--sources", "2"});
  EXPECT_EQ(run.code, 0) << run.err;
  expect_words(run.err, {"tiny/hill/src:", "unsupported: tiny is limited to",
                         "4 of 8 cells ok, 4 unsupported as declared; 2 of 3 meshes, 1 skipped"});
}

TEST_F(RunTest, InterleavedRepetitionsAreProcessesAndAlternate) {
  measure({"--solvers", exact_solver() + ",dijkstra", "--meshes", "hill,tetrahedron", "--sources",
           "1", "--interleave"});
  const json all = rows();
  ASSERT_EQ(all.size(), 8u);
  for (std::size_t i = 0; i < all.size(); i += 4) {
    const std::string solvers[] = {exact_solver(), "dijkstra", "dijkstra", exact_solver()};
    for (std::size_t k = 0; k < 4; ++k) {
      const json& each = all[i + k];
      EXPECT_EQ(each.at("solver"), solvers[k]);
      EXPECT_EQ(each.at("repetitions"), 2);
      EXPECT_EQ(each.at("repetition_index"), k / 2);
      EXPECT_EQ(each.contains("solver_peak_bytes"), k < 2) << "counted once";
      EXPECT_TRUE(each.contains("stolen_share") && each.contains("involuntary_switches_per_s"));
    }
  }
  EXPECT_EQ(run_context().at("interleaved"), true);
  EXPECT_TRUE(std::filesystem::exists(out_ / "cells" / "dijkstra__tetrahedron__src0__rep1.json"));
}

TEST_F(RunTest, ACellThatFailedHasNoFurtherRepetitions) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "crashing,dijkstra", "--meshes",
                                                "tetrahedron", "--sources", "1", "--interleave"});
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_EQ(rows().size(), 3u) << rows();
  EXPECT_EQ(row("crashing/tetrahedron/src:0").at("outcome"), "crashed");
}

TEST_F(RunTest, OtherProgramsAreMeasuredInPlaceOfThisOne) {
  const std::string program = PROGRAM;
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "dijkstra,tiny", "--meshes", "tetrahedron",
                                 "--sources", "1", "--cells", "dijkstra/tetrahedron/src:0",
                                 "--program", "base=" + program, "--program", "head=" + program});
  ASSERT_EQ(run.code, 0) << run.err;
  std::vector<std::string> programs;
  for (const json& each : rows()) programs.push_back(each.at("program"));
  EXPECT_EQ(programs, (std::vector<std::string>{"base", "head", "head", "base"}));
  const json context = run_context();
  ASSERT_EQ(context.at("programs").size(), 2u);
  EXPECT_EQ(context.at("programs")[1].at("name"), "head");
  EXPECT_EQ(context.at("programs")[1].at("revision"), context.at("revision"));
}

TEST_F(RunTest, ProgramsAndCellsThatMakeNoSenseAreRefused) {
  const std::string program = PROGRAM;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--program", "a=" + program}, "--program is given once"},
      {{"--program", program}, "not NAME=PATH"},
      {{"--program", "a=" + program, "--program", "b=/none"}, "no such file: /none"},
      {{"--program", "a=" + program, "--program", "a=" + program}, "two programs are named 'a'"},
      {{"--cells", "dijkstra/hill/src:99"}, "the run has no cell 'dijkstra/hill/src:99'"}};
  for (const auto& [words, message] : cases) {
    const Output run = run_suite(PROGRAM, words);
    EXPECT_EQ(run.code, 1);
    expect_words(run.err, {message});
  }
}

TEST_F(RunTest, MeshesWithDefectsAreRepairedOnRequest) {
  // Two triangles that share an edge in the same direction, and one without area.
  const auto mesh = write("dirty.off",
                          "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
                          "3 0 1 2\n3 1 2 3\n3 0 0 1\n");
  const std::vector<std::string> words{"--solvers",   "dijkstra",  "--meshes",
                                       mesh.string(), "--sources", "1"};
  EXPECT_EQ(run_suite(PROGRAM, words).code, 1);
  std::vector<std::string> repaired = words;
  repaired.emplace_back("--repair");
  const Output run = run_suite(PROGRAM, repaired);
  ASSERT_EQ(run.code, 0) << run.err;
  const json context = run_context();
  EXPECT_EQ(context.at("meshes")[0].at("repaired"), true);
}

TEST_F(RunTest, AReferenceThatFailsIsReplacedByTheNext) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "dijkstra", "--meshes", "tetrahedron",
                                                "--sources", "1", "--reference", "crashing"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(row("dijkstra/tetrahedron/src:0").at("reference"), "crashing");
}

TEST_F(RunTest, AReferenceThatDisagreesWithAnotherExactSolverIsNotUsed) {
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "wrong," + exact_solver(), "--meshes", "tetrahedron",
                                 "--sources", "1", "--reference", "oracle?off=0.1"});
  EXPECT_EQ(run.code, 2) << run.err;
  expect_words(run.err, {"tetrahedron, source 0: oracle?off=0.1 differs from "});
  const json right = row(exact_solver() + "/tetrahedron/src:0");
  EXPECT_EQ(right.at("outcome"), "ok") << right;
  EXPECT_NE(right.at("reference"), "oracle?off=0.1");
  const json wrong = row("wrong/tetrahedron/src:0");
  EXPECT_EQ(wrong.at("outcome"), "wrong answer");
  EXPECT_NEAR(wrong.value("max_relative_error", -1.0), 1e-9, 1e-12);
}

TEST_F(RunTest, ErrorsOfInexactSolversAreMeasuredAgainstTheRightReference) {
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "dijkstra", "--meshes", "tetrahedron", "--sources",
                                 "1", "--reference", "oracle?off=-0.1"});
  EXPECT_EQ(run.code, 0) << run.err;
  const json right = row("dijkstra/tetrahedron/src:0");
  EXPECT_NE(right.at("reference"), "oracle?off=-0.1");
  EXPECT_LE(right.at("max_relative_error").get<double>(), 1e-15);
}

// A manifest with one mesh: a box that the program generates, with distances in closed form.
class RunOfABox : public RunTest {
 protected:
  RunOfABox() {
    write("manifest.json", whole_manifest(R"({"corpora": {"quick": ["box"]}, "meshes": [
      {"name": "box", "kind": "generated", "generator": "box", "file": "box.ply",
      "parameters": {"x-cells": 4, "y-cells": 3, "z-cells": 2, "diagonal": "forward"}}]})"));
    make_box("4");
  }
  void make_box(const std::string& x_cells) const {
    const Output made = run_plainly(
        PROGRAM, {"generate", "box", "--x-cells", x_cells, "--y-cells", "3", "--z-cells", "2",
                  "--diagonal", "forward", "-o", (folder_ / "box.ply").string()});
    EXPECT_EQ(made.code, 0) << made.err;
  }
};

TEST_F(RunOfABox, IsVerifiedByItsClosedForm) {
  measure({"--solvers", exact_solver() + ",dijkstra", "--sources", "3"});
  for (const json& each : rows()) {
    EXPECT_EQ(each.at("reference"), "closed-form") << each.at("name");
    if (each.at("solver") != "dijkstra") {
      EXPECT_LE(each.at("max_relative_error").get<double>(), 1e-14) << each.at("name");
    }
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out_ / "references"), {}), 3)
      << "one file a source";
}

TEST_F(RunOfABox, CatchesWrongAnswersByItsClosedForm) {
  const Output run = run_suite(kFaultyProgram, {"--solvers", "wrong", "--sources", "1"});
  EXPECT_EQ(run.code, 2) << run.err;
  expect_words(message(row("wrong/box/src:0")), {"compared with closed-form"});
}

TEST_F(RunOfABox, IsVerifiedByTheSolverThatTheUserNames) {
  measure({"--solvers", "dijkstra", "--sources", "1", "--reference", exact_solver()});
  EXPECT_EQ(row("dijkstra/box/src:0").at("reference"), exact_solver());
}

TEST_F(RunOfABox, UsesTheClosedFormWhereTheNamedSolverCannotVerifyItself) {
  measure({"--solvers", exact_solver(), "--sources", "1", "--reference", exact_solver()});
  EXPECT_EQ(row(exact_solver() + "/box/src:0").at("reference"), "closed-form");
}

TEST_F(RunOfABox, IsVerifiedByASolverWhenItsFileIsAnotherMesh) {
  make_box("5");
  const Output run = run_suite(PROGRAM, {"--solvers", "dijkstra", "--sources", "1"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(row("dijkstra/box/src:0").at("reference"), "closed-form");
  expect_words(run.err, {"'box' cannot be verified by its closed form"});
}

TEST_F(RunOfABox, IsRefusedWhenTheManifestHasAnotherSumOfItsFile) {
  const auto run_with = [&](const std::string& sum) {
    json manifest = json::parse(read(folder_ / "manifest.json"));
    manifest["meshes"][0]["sha256"] = sum;
    write("manifest.json", manifest.dump());
    std::filesystem::remove_all(out_);
    return run_suite(PROGRAM, {"--solvers", "dijkstra", "--sources", "1"});
  };
  ASSERT_EQ(run_with(std::string(64, '0')).code, 0) << "not known yet";
  const json measured = json::parse(read(out_ / "run.json"));
  const json& box = measured.at("context").at("geodesic_bench").at("meshes").at(0);
  EXPECT_EQ(run_with(box.at("sha256")).code, 0);
  const Output refused = run_with(std::string(64, '1'));
  EXPECT_EQ(refused.code, 1);
  expect_words(refused.err, {"mesh 'box': ", "the manifest says 1111", "fetch.py box"});
}

// The parameters of a mesh that is made from another mesh do not determine its shape.
TEST_F(RunOfABox, WithAnInputHasNoClosedForm) {
  write("manifest.json", whole_manifest(R"({"corpora": {"quick": ["box"]}, "meshes": [
    {"name": "x", "kind": "generated", "file": "x.ply"},
    {"name": "box", "kind": "generated", "generator": "box", "inputs": {"input": "x"},
    "file": "box.ply",
    "parameters": {"x-cells": 4, "y-cells": 3, "z-cells": 2, "diagonal": "forward"}}]})"));
  measure({"--solvers", "dijkstra", "--sources", "1"});
  EXPECT_NE(row("dijkstra/box/src:0").at("reference"), "closed-form");
}

TEST_F(RunOfABox, SolveSaysHowFarItIsFromTheTruth) {
  const auto solve = [&](const Program& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"solve", "box"});
    return run(program, arguments);
  };
  const Output sound =
      solve(PROGRAM, {"--solver", exact_solver(), "--source", "0", "--source", "30"});
  ASSERT_EQ(sound.code, 0) << sound.err;
  EXPECT_EQ(json::parse(sound.out).at("reference"), "closed-form");
  EXPECT_LE(json::parse(sound.out).at("max_relative_error").get<double>(), 1e-14);

  const Output limited =
      solve(PROGRAM, {"--solver", exact_solver(), "--source", "0", "--limit", "2"});
  ASSERT_EQ(limited.code, 0) << limited.err;
  EXPECT_TRUE(json::parse(limited.out).at("reference").is_null());

  const Output wrong = solve(kFaultyProgram, {"--solver", "wrong", "--source", "0"});
  EXPECT_EQ(wrong.code, 2) << wrong.err;
  EXPECT_EQ(wrong.out, "");
  expect_words(wrong.err, {"compared with closed-form"});
}

TEST_F(RunOfABox, ListSaysThatItsDistancesAreKnown) {
  EXPECT_EQ(json::parse(run(PROGRAM, {"list", "--json"}).out).at("meshes")[0].at("distances_known"),
            true);
}

TEST_F(RunTest, UnreadableMeshesAreSkippedAndAnError) {
  write("absent.ply", "not a mesh");
  const Output run = run_suite(PROGRAM, {"--solvers", "dijkstra", "--sources", "1"});
  EXPECT_EQ(run.code, 1) << run.err;
  const json skipped = run_context().at("skipped");
  ASSERT_EQ(skipped.size(), 1u);
  EXPECT_EQ(skipped[0].at("mesh"), "absent");
  EXPECT_EQ(rows().size(), 4u) << "the other meshes are measured";
}

}  // namespace
}  // namespace geodesic::harness
