// How child processes end, and that none outlives its time limit.
#include "harness/base/process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "harness/base/interruption.h"

namespace geodesic::harness {
namespace {

constexpr double kLong = 60;  // seconds

Ended run_in_shell(const std::string& script, double time_limit) {
  return run_program("/bin/sh", {"-c", script}, [] {}, {.seconds = time_limit});
}

TEST(RunProgram, tells_how_the_process_ended_and_its_error_lines) {
  const Ended ended = run_in_shell("echo one >&2; echo two >&2; exit 3", kLong);
  EXPECT_FALSE(ended.crashed || ended.timed_out || ended.succeeded());
  EXPECT_EQ(ended.describe(), "exit code 3: one | two");
  const Ended killed = run_in_shell("kill -SEGV $$", kLong);
  EXPECT_TRUE(killed.crashed);
  EXPECT_EQ(killed.code, SIGSEGV);
  EXPECT_TRUE(run_in_shell("exit 0", kLong).succeeded());
}

TEST(RunProgram, is_interrupted_when_the_signal_of_a_whole_group_reaches_the_child_first) {
  const InterruptionGuard guard;
  std::jthread scheduler([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    kill(getpid(), SIGTERM);
  });
  EXPECT_THROW(run_in_shell("kill -TERM $$", kLong), Interrupted);
}

TEST(InterruptionGuard, takes_two_signals_at_once_for_one_and_ends_at_a_later_one) {
  const InterruptionGuard guard;
  raise(SIGTERM);
  raise(SIGTERM);
  EXPECT_THROW(throw_if_interrupted(), Interrupted);
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  EXPECT_EXIT(raise(SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST(RunProgram, knows_a_crash_by_a_signal_that_comes_to_the_child_alone) {
  const InterruptionGuard guard;
  const Ended ended = run_in_shell("kill -TERM $$", kLong);
  EXPECT_TRUE(ended.crashed);
  EXPECT_EQ(ended.code, SIGTERM);
}

TEST(RunProgram, kills_what_does_not_end_in_time) {
  const Ended ended = run_in_shell("echo last words >&2; exec sleep 600", 0.5);
  EXPECT_TRUE(ended.timed_out);
  EXPECT_EQ(ended.error_lines, "last words");
}

TEST(RunProgram, kills_what_closed_its_standard_error_and_waits_for_what_ends_after_that) {
  EXPECT_TRUE(run_in_shell("exec 2>&-; exec sleep 600", 0.5).timed_out);
  const Ended ended = run_in_shell("exec 2>&-; sleep 0.1; exit 3", kLong);
  EXPECT_FALSE(ended.timed_out);
  EXPECT_EQ(ended.code, 3);
}

TEST(RunProgram, is_not_kept_by_a_grandchild_that_holds_standard_error) {
  EXPECT_TRUE(run_in_shell("sleep 5 & exit 0", 0.5).succeeded());
}

}  // namespace
}  // namespace geodesic::harness
