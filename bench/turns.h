// Comparing two things on a machine that others use too: let them take turns, and compare within the round.
//
// A number measured now and another measured a minute later differ by whatever the machine did in between. So
// one benchmark here is one *comparison*: each repetition (Google Benchmark's word; here, a round) runs every
// contestant once, one right after the other, and leaves its seconds in a counter of its name. bench/run.py
// takes ratios within each round and then the median over rounds.
//
//     void sorting(benchmark::State& state) {
//       Turns turns(state);                                    // one round
//       turns.take("std::sort", [&] { copy = data; }, [&] { std::sort(copy.begin(), copy.end()); });
//     }                                                        // counters["std::sort"] = seconds
//
// On one core (a process allowed to run on one only) the clock counts this process's processor time, so that
// neighbors who take the core away do not count. On several it counts wall time: there is no other way.
#pragma once

#include <benchmark/benchmark.h>
#include <malloc.h>
#include <sched.h>
#include <time.h>

#include <string>

namespace seesaw::bench {

/// Whether this process may use one core only.
inline bool on_one_core() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return sched_getaffinity(0, sizeof cores, &cores) == 0 && CPU_COUNT(&cores) == 1;
}

inline double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor seconds that all threads of this process have worked.
inline double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

/// Seconds: of this process's work on one core, of the wall on several.
inline double seconds_now() {
  static const bool alone = on_one_core();
  return alone ? processor_seconds() : seconds_of(CLOCK_MONOTONIC);
}

/// Makes every large allocation come fresh from the operating system, as a program's first one does.
/// Otherwise the allocator hands the second round the first round's pages, and the cost of getting them is
/// measured once only.
inline void allocate_afresh() { mallopt(M_MMAP_THRESHOLD, 1 << 20); }

class Turns {
 public:
  /// Tells Google Benchmark that its round has begun; the whole round is its "iteration".
  explicit Turns(benchmark::State& state) : state_(state) {
    while (state_.KeepRunning()) {
    }
  }

  /// `prepare` is not timed; `work` is, and its seconds land in counters[name].
  template <class Prepare, class Work>
  double take(const std::string& name, const Prepare& prepare, const Work& work) {
    prepare();
    const double start = seconds_now();
    work();
    const double seconds = seconds_now() - start;
    note(name, seconds);
    return seconds;
  }
  template <class Work>
  double take(const std::string& name, const Work& work) {
    return take(
        name, [] {}, work);
  }
  /// A number that is not a time.
  void note(const std::string& name, double number) { state_.counters[name] = number; }

 private:
  benchmark::State& state_;
};

/// Registers a comparison of which each repetition is one round.
template <class Round>
void add_comparison(const std::string& name, const Round& round) {
  benchmark::RegisterBenchmark(name.c_str(), round)->Iterations(1);
}

}  // namespace seesaw::bench
