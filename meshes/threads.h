// Runs independent pieces of work in several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace geodesic {

/// Function that does one piece of work; called repeatedly in one thread.
using Worker = std::function<void(std::size_t piece)>;

/// Does the pieces 0 to count - 1, each once, in several threads. Every thread makes its own worker
/// and takes the next piece whenever it is free. If no more threads can start, the others do all.
/// @param threads at least 1; with 1, the calling thread does all pieces in order
/// @throws the exception of the least piece that threw, after all threads have ended; pieces that
///         were not started by then are skipped
void do_in_threads(std::size_t count, unsigned threads, const std::function<Worker()>& make_worker);

}  // namespace geodesic
