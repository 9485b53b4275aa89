// How long one period of the driver of LUCS Hand II takes on each bus, without the lines: decoding,
// safety, motion, encoding and the log. The median and the 99th of 100 periods, in microseconds.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "base/files/embedded.h"
#include "bodies/explorers/simulated_body.h"
#include "hardware/device_files/device_text.h"
#include "hardware/devices/device_body.h"
#include "hardware/emulation/emulated_body.h"
#include "hardware/emulation/emulated_lines.h"
#include "hardware/emulation/replayed_lines.h"

namespace somato {
namespace {

constexpr int kPeriods = 250;

template <typename T>
T value_of(Result<T> result) {
  if (result) return std::move(*result);
  std::cerr << "device_bench: " << to_string(result.error()) << "\n";
  std::exit(1);
}

devices::DeviceFile hand_on(devices::BusKind bus) {
  const std::string text(detail::embedded_text("devices/lucs2.toml"));
  return value_of(
      devices::parse_device_file(value_of(devices::with_bus(text, "lucs2", bus)), "lucs2"));
}

// Closes the hand by a period at a time; `around` is called with each step.
template <typename Around>
void close_hand(const devices::DeviceFile& file, wire::Lines& lines, const Around& around) {
  const auto body = value_of(devices::DeviceBody::start(file, lines));
  std::vector<double> targets = body->state().positions;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i] += 0.5 * (body->description().degrees_of_freedom[i].most - targets[i]);
  }
  if (!body->command(targets)) std::abort();
  for (int i = 0; i < kPeriods; ++i) {
    around([&] {
      if (!body->step(file.settings.period)) std::abort();
    });
  }
}

std::vector<emulation::LineEvent> recorded(const devices::DeviceFile& file) {
  const ObjectTable things = value_of(default_things(ExploringBody::kLucs2));
  emulation::EmulatedBody body(
      file, value_of(simulated_body(ExploringBody::kLucs2, things, {}, 1, 0, 0)));
  emulation::EmulatedLines lines(body.wires(), [&](double now) {
    if (!body.advance(now)) std::abort();
  });
  emulation::RecordedLines recorded(lines);
  close_hand(file, recorded, [](const auto& step) { step(); });
  return recorded.events();
}

double microseconds_of(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void device_period(benchmark::State& state, devices::BusKind bus) {
  const devices::DeviceFile file = hand_on(bus);
  const std::vector<emulation::LineEvent> events = recorded(file);
  std::vector<double> times;
  for (auto _ : state) {
    emulation::ReplayedLines lines(events);
    close_hand(file, lines, [&](const auto& step) {
      const auto begin = std::chrono::steady_clock::now();
      step();
      const auto end = std::chrono::steady_clock::now();
      times.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    });
  }
  std::sort(times.begin(), times.end());
  state.counters["p50_us"] = microseconds_of(times, 0.5);
  state.counters["p99_us"] = microseconds_of(times, 0.99);
  state.SetItemsProcessed(static_cast<std::int64_t>(times.size()));
}

BENCHMARK_CAPTURE(device_period, ssc32, devices::BusKind::kSsc32)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(device_period, dynamixel, devices::BusKind::kDynamixel)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(device_period, sts, devices::BusKind::kSts)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(device_period, scs, devices::BusKind::kScs)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace somato
