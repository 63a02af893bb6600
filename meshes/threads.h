// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace geodesic {

/// Does one piece of work after the other, in one thread.
using Worker = std::function<void(std::size_t piece)>;

/// Does the pieces 0 to count - 1, each once, on as many threads: every thread makes a worker of
/// its own and takes the next piece whenever it is free.
/// @param threads at least 1; with 1 everything happens in order in this thread
/// @throws the exception of the least piece that threw, after all threads have ended; pieces that
///         had not been started by then are not done
void do_in_threads(std::size_t count, unsigned threads, const std::function<Worker()>& make_worker);

}  // namespace geodesic
