// Measures the limits of this machine, as JSON: multiply-adds in registers [FLOP/s], and reading,
// changing and writing memory that no cache holds [bytes/s]; each the median of several repeats.
//
//     limits THREADS

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace {

constexpr int kRepeats = 7;
constexpr std::size_t kAccumulators = 12;
constexpr std::uint64_t kSteps = 4'000'000;
constexpr std::size_t kBytes = std::size_t{256} << 20;

volatile float sink_of_floats;
volatile std::uint64_t sink_of_words;

// Each returns the number of floating-point operations that it did.
#if defined(__x86_64__)
__attribute__((target("avx512f"))) double multiply_add_512() {
  std::array<__m512, kAccumulators> sums{};
  const __m512 factor = _mm512_set1_ps(0.5F);
  for (std::uint64_t step = 0; step < kSteps; ++step) {
#pragma GCC unroll 12
    for (std::size_t i = 0; i < kAccumulators; ++i) {
      sums[i] = _mm512_fmadd_ps(sums[i], factor, factor);
    }
  }
  for (const __m512 sum : sums) sink_of_floats = _mm512_reduce_add_ps(sum);
  return 2.0 * 16 * kAccumulators * kSteps;
}

__attribute__((target("avx2,fma"))) double multiply_add_256() {
  std::array<__m256, kAccumulators> sums{};
  const __m256 factor = _mm256_set1_ps(0.5F);
  for (std::uint64_t step = 0; step < kSteps; ++step) {
#pragma GCC unroll 12
    for (std::size_t i = 0; i < kAccumulators; ++i) {
      sums[i] = _mm256_fmadd_ps(sums[i], factor, factor);
    }
  }
  for (const __m256 sum : sums) sink_of_floats = _mm256_cvtss_f32(sum);
  return 2.0 * 8 * kAccumulators * kSteps;
}
#endif

double multiply_add_portable() {
  std::array<float, 4 * kAccumulators> sums{};
  for (std::uint64_t step = 0; step < kSteps; ++step) {
    for (float& sum : sums) sum = sum * 0.5F + 0.5F;
  }
  for (const float sum : sums) sink_of_floats = sum;
  return 2.0 * static_cast<double>(sums.size()) * kSteps;
}

double multiply_add() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return multiply_add_512();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return multiply_add_256();
#endif
  return multiply_add_portable();
}

// Calls `work(thread)` in all threads at once; what they did in all, a second.
double rate(unsigned threads, const std::function<double(unsigned)>& work) {
  std::vector<double> rates;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    std::vector<double> done(threads);
    std::vector<std::thread> others;
    const auto begin = std::chrono::steady_clock::now();
    for (unsigned t = 1; t < threads; ++t) others.emplace_back([&, t] { done[t] = work(t); });
    done[0] = work(0);
    for (std::thread& other : others) other.join();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    double all = 0.0;
    for (const double part : done) all += part;
    rates.push_back(all / took.count());
  }
  std::nth_element(rates.begin(), rates.begin() + kRepeats / 2, rates.end());
  return rates[kRepeats / 2];
}

double read(const std::vector<std::uint64_t>& memory) {
  std::uint64_t sum = 0;
  for (const std::uint64_t word : memory) sum += word;
  sink_of_words = sum;
  return static_cast<double>(memory.size() * sizeof(std::uint64_t));
}

double change(std::vector<std::uint64_t>& memory) {
  for (std::uint64_t& word : memory) word += 3;
  return 2.0 * static_cast<double>(memory.size() * sizeof(std::uint64_t));
}

double write(std::vector<std::uint64_t>& memory, std::uint64_t value) {
  std::fill(memory.begin(), memory.end(), value);
  return static_cast<double>(memory.size() * sizeof(std::uint64_t));
}

}  // namespace

int main(int count, char** arguments) {
  const unsigned threads = count > 1 ? static_cast<unsigned>(std::stoul(arguments[1])) : 1;
  std::vector<std::vector<std::uint64_t>> memory(
      threads, std::vector<std::uint64_t>(kBytes / threads / sizeof(std::uint64_t), 1));
  const double flops = rate(threads, [](unsigned /*thread*/) { return multiply_add(); });
  const double reads = rate(threads, [&](unsigned t) { return read(memory[t]); });
  const double changes = rate(threads, [&](unsigned t) { return change(memory[t]); });
  const double writes = rate(threads, [&](unsigned t) { return write(memory[t], t); });
  fmt::print(R"({{"threads": {}, "flops": {:.4g}, "read": {:.4g}, "change": {:.4g}, )"
             R"("write": {:.4g}}})"
             "\n",
             threads, flops, reads, changes, writes);
}
