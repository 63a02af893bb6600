#include "meshes/threads.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace geodesic::harness {
namespace {

TEST(Threads, DoEveryPieceOnce) {
  for (const unsigned threads : {1u, 2u, 7u, 40u}) {
    std::vector<std::atomic<int>> done(23);
    do_in_threads(done.size(), threads, [&] { return [&](std::size_t i) { ++done[i]; }; });
    for (const auto& times : done) EXPECT_EQ(times, 1) << threads << " threads";
  }
}

TEST(Threads, OfOneIsTheCallersAndKeepsTheOrder) {
  std::vector<std::size_t> order;
  const auto caller = std::this_thread::get_id();
  do_in_threads(5, 1, [&] {
    return [&](std::size_t i) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      order.push_back(i);
    };
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Threads, HaveAWorkerEachAndNoneForNoWork) {
  std::atomic<int> workers = 0;
  const auto make = [&] {
    ++workers;
    return [](std::size_t) {};
  };
  do_in_threads(100, 3, make);
  EXPECT_EQ(workers, 3);
  workers = 0;
  do_in_threads(2, 8, make);
  EXPECT_EQ(workers, 2);
}

// Threads of the default size need more memory than there is, so that none can start.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t attributes = before_;
    pthread_attr_setstacksize(&attributes, std::size_t{1} << 50);
    pthread_setattr_default_np(&attributes);
  }
  ~NoMoreThreads() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;

 private:
  pthread_attr_t before_;
};

TEST(Threads, DoEveryPieceOnceWhereNoMoreCanStart) {
  std::vector<int> done(23);
  const NoMoreThreads no_more;
  ASSERT_THROW(std::jthread([] {}), std::system_error);
  do_in_threads(done.size(), 4, [&] { return [&](std::size_t i) { ++done[i]; }; });
  EXPECT_EQ(done, std::vector<int>(23, 1));
}

TEST(Threads, PassOnAnExceptionAndStop) {
  for (const unsigned threads : {1u, 4u}) {
    std::atomic<int> done = 0;
    const auto work = [&] {
      do_in_threads(100000, threads, [&] {
        return [&](std::size_t i) {
          if (i == 3) throw std::runtime_error("piece 3");
          ++done;
        };
      });
    };
    EXPECT_THROW(work(), std::runtime_error);
    EXPECT_LT(done, 100000);
  }
}

}  // namespace
}  // namespace geodesic::harness
