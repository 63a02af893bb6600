// What the authors' code uses of the header of this name, on other systems.
#pragma once

#include <cfloat>
#include <chrono>
#include <climits>
#include <cstdio>
#include <cstring>

using __int64 = long long;

struct LARGE_INTEGER {
  long long QuadPart;
};

inline bool QueryPerformanceFrequency(LARGE_INTEGER* frequency) {
  frequency->QuadPart = std::chrono::steady_clock::period::den;
  return true;
}

inline bool QueryPerformanceCounter(LARGE_INTEGER* counter) {
  counter->QuadPart = std::chrono::steady_clock::now().time_since_epoch().count();
  return true;
}

inline unsigned long GetTickCount() {
  using std::chrono::milliseconds;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<milliseconds>(now).count();
}

inline bool DeleteFile(const char* name) { return std::remove(name) == 0; }
