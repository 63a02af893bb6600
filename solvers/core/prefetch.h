// Asking for memory before it is needed.
#pragma once

namespace geodesic {

/// Starts to bring the cache line at an address near; the address may be anything.
inline void prefetch(const void* address) { __builtin_prefetch(address); }

}  // namespace geodesic
