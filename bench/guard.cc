// Fixed work for each kernel, and small whole trainings, for callgrind to count the instructions of
// (bench/guard.py), or on 64-bit ARM for the plugin of qemu-user (bench/guard_arm64.py): no clock,
// and the same count on every run.
//
//     guard SET         does everything with this instruction set, printing names and digests
//     guard --check     with every set that this processor has; fails when results are not the
//                       same bits
//     guard --compiler  prints what it was compiled by

#include "guard.h"

#include <fmt/format.h>

#include <iostream>
#include <map>

#include "base/kernels/instruction_set.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name)
#endif
#if defined(__aarch64__)
#include <sys/prctl.h>
#endif

namespace somato::bench {
namespace {

void count_all(const Counted& counted) {
  count_map_kernels(counted);
  count_batch_kernels(counted);
  count_online_kernels(counted);
  count_product_kernels(counted);
  count_t_mpsom_kernels(counted);
  count_distance_kernels(counted);
  count_activity_kernels(counted);
  count_cases(counted);
}

// Known to bench/instruction_counter.cc: Linux refuses the call, which changes nothing.
void mark([[maybe_unused]] unsigned long end) {
#if defined(__aarch64__)
  constexpr int kMark = 0x536F6D61;
  prctl(kMark, end, 0UL, 0UL, 0UL);
#endif
}

// Calls take(name, digest) for each part, in the order in which they are counted.
template <typename Take>
void count_with(InstructionSet set, const Take& take) {
  use_instruction_set(set);
  count_all([&](const std::string& name, const Work& work, const Digest& bits) {
    CALLGRIND_ZERO_STATS;
    mark(0);
    work();
    mark(1);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
    take(name, bits());
  });
}

using Digests = std::map<std::string, std::uint64_t>;

Digests digests_with(InstructionSet set) {
  Digests digests;
  count_with(set, [&](const std::string& name, std::uint64_t digest) { digests[name] = digest; });
  return digests;
}

int check_sets() {
  int differing = 0;
  const Digests portable = digests_with(InstructionSet::kPortable);
  for (const InstructionSet set : available_instruction_sets()) {
    for (const auto& [name, digest] : digests_with(set)) {
      if (digest == portable.at(name)) continue;
      std::cerr << "guard: " << name_of(set) << " gives other bits in " << name << "\n";
      ++differing;
    }
  }
  return differing == 0 ? 0 : 1;
}

int run_with(const std::string& name) {
  for (const InstructionSet set : available_instruction_sets()) {
    if (name_of(set) != name) continue;
    count_with(set, [](const std::string& what, std::uint64_t digest) {
      fmt::print("{} {:016x}\n", what, digest);
    });
    return 0;
  }
  std::cerr << "guard: there is no instruction set '" << name << "' here\n";
  return 3;
}

}  // namespace
}  // namespace somato::bench

int main(int count, char** arguments) {
  const std::string what = count > 1 ? arguments[1] : "--check";
  if (what == "--compiler") {
#if defined(__clang__)
    fmt::print("clang++ {}.{}\n", __clang_major__, __clang_minor__);
#else
    fmt::print("g++ {}.{}\n", __GNUC__, __GNUC_MINOR__);
#endif
    return 0;
  }
  return what == "--check" ? somato::bench::check_sets() : somato::bench::run_with(what);
}
