#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <filesystem>
#include <map>
#include <numbers>
#include <numeric>

#include "base/files/toml_file.h"
#include "base/support/places.h"
#include "somato/recording/csv_import.h"

namespace somato {
namespace {

// The shipped example, against what its README says.

// The frequency in Hz of the strongest wave in `values` between 1 and 15 Hz.
double strongest_frequency(const std::vector<double>& values, double rate) {
  const double mean =
      std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
  double strongest = 0.0;
  double most = 0.0;
  for (int i = 20; i <= 300; ++i) {
    const double frequency = i / 20.0;
    std::complex<double> sum = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n) {
      const double angle = 2.0 * std::numbers::pi * frequency * static_cast<double>(n) / rate;
      sum += (values[n] - mean) * std::polar(1.0, angle);
    }
    if (std::norm(sum) > most) strongest = frequency;
    most = std::max(most, std::norm(sum));
  }
  return strongest;
}

TEST(SyntheticStrokes, AreWhatTheirReadmeSays) {
  const auto folder = std::filesystem::path(source_path("examples/synthetic_strokes"));
  const auto recording =
      read_toml((folder / "import.toml").string())
          .and_then(read_csv_import)
          .and_then([&](const CsvImport& plan) { return import_csv_trials(folder, plan); });
  ASSERT_TRUE(recording) << to_string(recording.error());
  EXPECT_TRUE(validate(*recording));
  EXPECT_EQ(recording->explorations.size(), 24U);
  EXPECT_EQ(label_values(*recording, "trial"), (std::vector<std::string>{"1", "2"}));
  const std::map<std::string, double> ridges{
      {"coarse_rib", 0.04}, {"coarse_knit", 0.065}, {"fine_rib", 0.1}, {"fine_knit", 0.16}};
  for (const Exploration& stroke : recording->explorations) {
    const Channel& touch = *find_channel(stroke, "touch").value();
    ASSERT_EQ(touch.frames.rows(), 96U);
    ASSERT_EQ(touch.frames.columns(), 4U);
    EXPECT_DOUBLE_EQ(touch.times.back(), 95 * 0.02);
    const double speed = find_channel(stroke, "speed").value()->frames(0, 0);
    std::vector<double> first_taxel;
    for (std::size_t i = 0; i < 96; ++i) first_taxel.push_back(touch.frames(i, 0));
    EXPECT_NEAR(strongest_frequency(first_taxel, 50.0),
                speed * ridges.at(find_label(stroke, "fabric").value()), 0.2)
        << stroke.source;
  }
}

}  // namespace
}  // namespace somato
