#include "somato/codes/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "systems/support/plain_transform.h"

namespace somato {
namespace {

Matrix<float> noise(Random& random, std::size_t frames, std::size_t elements) {
  Matrix<float> made(frames, elements);
  for (float& value : made.values()) value = static_cast<float>(3.0 + random.normal());
  return made;
}

// `amplitude` times a sine of `frequency` Hz.
Matrix<float> sine(double frequency, double rate, std::size_t frames, double amplitude = 1.0) {
  Matrix<float> made(frames, 1);
  for (std::size_t i = 0; i < frames; ++i) {
    const double turns = frequency * static_cast<double>(i) / rate + 0.1;
    made(i, 0) = static_cast<float>(amplitude * std::sin(2.0 * std::numbers::pi * turns));
  }
  return made;
}

std::size_t greatest_place(std::span<const float> values) {
  return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
}

SpectrumParameters every_bin(std::size_t segment_length) {
  SpectrumParameters parameters;
  parameters.segment_length = segment_length;
  parameters.bands = 0;
  return parameters;
}

std::string complaint(const Result<Signal>& result, ErrorKind kind = ErrorKind::kData) {
  if (result) return {};
  EXPECT_EQ(result.error().kind, kind);
  return result.error().what;
}

// The oracle: every step written out as slowly as it is defined.

std::vector<double> oracle_window(SpectrumWindow window, std::size_t count) {
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = (static_cast<double>(2 * i + 1)) / static_cast<double>(2 * count);
    const double cosine = std::cos(2.0 * std::numbers::pi * turn);
    weights.push_back(window == SpectrumWindow::kHann      ? (1.0 - cosine) / 2.0
                      : window == SpectrumWindow::kHamming ? 0.54 - 0.46 * cosine
                                                           : 1.0);
  }
  return weights;
}

std::vector<double> oracle_segment(const SpectrumParameters& parameters, std::vector<double> values,
                                   std::size_t transform_length) {
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  const std::vector<double> weights = oracle_window(parameters.window, values.size());
  double weight_squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = weights[i] * (values[i] - (parameters.remove_mean ? mean : 0.0));
    weight_squares += weights[i] * weights[i];
  }
  values.resize(transform_length, 0.0);
  std::vector<double> bins = testing::plain_squares(values);
  for (double& bin : bins) bin *= 2.0 / weight_squares / static_cast<double>(transform_length);
  return bins;
}

std::vector<double> oracle_bins(const SpectrumParameters& parameters, const Matrix<float>& frames,
                                std::size_t element, std::size_t transform_length) {
  const std::size_t length = parameters.segment_length.value_or(frames.rows());
  const double kept = std::floor(parameters.overlap * static_cast<double>(length));
  std::vector<double> mean(transform_length / 2 + 1, 0.0);
  double count = 0.0;
  for (std::size_t start = 0; start + length <= frames.rows();
       start += length - static_cast<std::size_t>(kept)) {
    std::vector<double> values;
    for (std::size_t i = start; i < start + length; ++i) values.push_back(frames(i, element));
    const std::vector<double> bins = oracle_segment(parameters, values, transform_length);
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += bins[k];
    count += 1.0;
  }
  for (double& bin : mean) bin /= count;
  return mean;
}

double oracle_value(const SpectrumParameters& parameters, double power) {
  return parameters.quantity == SpectrumQuantity::kPower ? power : std::sqrt(power);
}

// The density at 200000 places of the band, each belonging to the bin nearest to it.
double oracle_band(const std::vector<double>& bins, double step, double low, double high) {
  constexpr int kPlaces = 200000;
  double sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double frequency = low + (high - low) * (i + 0.5) / kPlaces;
    sum += bins[static_cast<std::size_t>(std::lround(frequency / step))];
  }
  return sum * (high - low) / kPlaces / step;
}

TEST(Spectrum, AgreesWithTheOracleInEveryBin) {
  Random random(1);
  for (int problem = 0; problem < 120; ++problem) {
    SpectrumParameters parameters = every_bin(1 + random.below(60));
    parameters.window = Choices<SpectrumWindow>::all()[random.below(3)].first;
    parameters.overlap = 0.9 * random.uniform();
    parameters.remove_mean = random.below(2) == 0;
    parameters.quantity = Choices<SpectrumQuantity>::all()[random.below(2)].first;
    const std::size_t segment = *parameters.segment_length;
    std::size_t length = std::bit_ceil(segment);
    if (random.below(2) == 0) {
      length = std::max<std::size_t>(2, segment + random.below(30));
      parameters.transform_length = length;
    }
    const Matrix<float> frames = noise(random, segment + random.below(100), 2);
    const Signal found = Spectrum(parameters).apply(frames, 0.0).value();
    ASSERT_EQ(found.shape(), (std::vector<std::size_t>{2, length / 2 + 1}));
    for (std::size_t element = 0; element < 2; ++element) {
      const std::vector<double> bins = oracle_bins(parameters, frames, element, length);
      for (std::size_t k = 0; k < bins.size(); ++k) {
        EXPECT_NEAR(found.values()[element * bins.size() + k], oracle_value(parameters, bins[k]),
                    1e-6 * (1.0 + bins[k]))
            << "problem " << problem << ", element " << element << ", bin " << k;
      }
    }
  }
}

TEST(Spectrum, AgreesWithTheOracleInBandsOfAWholeExploration) {
  Random random(2);
  for (int problem = 0; problem < 40; ++problem) {
    const Matrix<float> frames = noise(random, 20 + random.below(100), 1);
    const std::size_t length = std::bit_ceil(frames.rows());
    const double rate = 10.0 + 100.0 * random.uniform();
    std::optional<double> speed;
    if (problem % 2 == 0) speed = -(5.0 + random.uniform());
    const double unit = std::fabs(speed.value_or(1.0));
    SpectrumParameters parameters;
    parameters.bands = 1 + random.below(9);
    parameters.low = 0.2 * random.uniform() * rate / unit;
    parameters.high = (0.21 + 0.29 * random.uniform()) * rate / unit;
    const Signal found = Spectrum(parameters).apply(frames, rate, speed).value();
    const std::vector<double> bins = oracle_bins(parameters, frames, 0, length);
    const double step = rate / static_cast<double>(length) / unit;
    const double width =
        (*parameters.high - parameters.low) / static_cast<double>(parameters.bands);
    for (std::size_t band = 0; band < parameters.bands; ++band) {
      const double low = parameters.low + width * static_cast<double>(band);
      EXPECT_NEAR(found.values()[band], std::sqrt(oracle_band(bins, step, low, low + width)), 1e-4)
          << "problem " << problem << ", band " << band;
    }
  }
}

// Parseval, for any lengths: the power of all bands together is the frames' mean square.
TEST(Spectrum, SharesOutTheMeanSquareOfTheFrames) {
  Random random(3);
  for (const std::size_t length : {100U, 128U, 37U}) {
    for (const std::size_t transform_length : {128U, 129U, 210U}) {
      const Matrix<float> frames = noise(random, length, 1);
      SpectrumParameters parameters;
      parameters.window = SpectrumWindow::kRectangular;
      parameters.quantity = SpectrumQuantity::kPower;
      parameters.remove_mean = false;
      parameters.transform_length = transform_length;
      parameters.bands = 1 + random.below(50);
      const Signal found = Spectrum(parameters).apply(frames, 40.0).value();
      double expected = 0.0;
      for (const float value : frames.values()) expected += double{value} * double{value};
      double sum = 0.0;
      for (const float value : found.values()) sum += double{value};
      EXPECT_NEAR(sum, expected / static_cast<double>(length), 1e-5);
    }
  }
}

// A sine of amplitude 6 has the mean square 18. The Hann window shares it out 1 : 4 : 1 among three
// bins.
TEST(Spectrum, ShowsASineInItsBin) {
  SpectrumParameters parameters = every_bin(128);
  parameters.quantity = SpectrumQuantity::kPower;
  const Matrix<float> frames = sine(12.5, 100.0, 512, 6.0);  // bin 12.5 * 128 / 100 = 16
  const Signal hann = Spectrum(parameters).apply(frames, 100.0).value();
  EXPECT_NEAR(hann.values()[15], 3.0, 1e-4);
  EXPECT_NEAR(hann.values()[16], 12.0, 1e-4);
  EXPECT_NEAR(hann.values()[17], 3.0, 1e-4);
  EXPECT_NEAR(hann.values()[18], 0.0, 1e-4);
  parameters.window = SpectrumWindow::kRectangular;
  const Signal rectangular = Spectrum(parameters).apply(frames, 100.0).value();
  EXPECT_NEAR(rectangular.values()[16], 18.0, 1e-4);
  EXPECT_NEAR(rectangular.values()[15], 0.0, 1e-4);
  parameters.quantity = SpectrumQuantity::kMagnitude;
  const Signal root = Spectrum(parameters).apply(frames, 100.0).value();
  EXPECT_NEAR(root.values()[16], std::sqrt(18.0), 1e-5);
}

TEST(Spectrum, PutsASineIntoItsBand) {
  SpectrumParameters parameters;
  parameters.bands = 10;
  parameters.low = 10.0;
  parameters.high = 110.0;
  for (std::size_t band = 0; band < 10; ++band) {
    const double frequency = 15.0 + 10.0 * static_cast<double>(band);
    const Signal found = Spectrum(parameters).apply(sine(frequency, 250.0, 400), 250.0).value();
    EXPECT_EQ(greatest_place(found.values()), band);
  }
}

// A texture with gratings of 0.25 and 0.75 cycles/mm, stroked at `speed` mm/s.
Matrix<float> texture(double speed) {
  const Matrix<float> coarse = sine(0.25 * speed, 200.0, 1200, 2.0);
  Matrix<float> both = sine(0.75 * speed, 200.0, 1200, 1.0);
  for (std::size_t i = 0; i < both.rows(); ++i) both(i, 0) += coarse(i, 0);
  return both;
}

TEST(Spectrum, OfATextureIsNearlyTheSameAtTwoSpeeds) {
  SpectrumParameters parameters;
  parameters.segment_length = 600;
  parameters.bands = 10;
  parameters.high = 1.0;
  const Spectrum spectrum(parameters);
  const Signal slow = spectrum.apply(texture(20.0), 200.0, 20.0).value();
  const Signal fast = spectrum.apply(texture(33.0), 200.0, 33.0).value();
  for (std::size_t band = 0; band < 10; ++band) {
    EXPECT_NEAR(slow.values()[band], fast.values()[band], 0.02) << band;
  }
  EXPECT_NEAR(fast.values()[2], 2.0 / std::sqrt(2.0), 0.02);
  EXPECT_NEAR(fast.values()[7], 1.0 / std::sqrt(2.0), 0.02);
  parameters.high = 20.0;
  const Signal in_hertz = Spectrum(parameters).apply(texture(33.0), 200.0).value();
  EXPECT_NEAR(in_hertz.values()[2], 0.0, 0.02);
}

TEST(Spectrum, OfAStrokeBackwardsIsThatOfAStrokeForwards) {
  SpectrumParameters parameters;
  parameters.bands = 8;
  parameters.high = 1.0;
  const Spectrum spectrum(parameters);
  const Matrix<float> frames = sine(10.0, 200.0, 1200);
  EXPECT_EQ(spectrum.apply(frames, 200.0, -20.0).value(),
            spectrum.apply(frames, 200.0, 20.0).value());
}

TEST(Spectrum, DoesNotContainAMeanThatWasRemoved) {
  const Matrix<float> constant(64, 1, 5.0F);
  SpectrumParameters parameters = every_bin(64);
  const Signal removed = Spectrum(parameters).apply(constant, 0.0).value();
  EXPECT_EQ(*std::ranges::max_element(removed.values()), 0.0F);
  parameters.remove_mean = false;
  const Signal kept = Spectrum(parameters).apply(constant, 0.0).value();
  EXPECT_GT(kept.values()[0], 5.0F);
  EXPECT_NEAR(kept.values()[2], 0.0, 1e-6);
}

TEST(Spectrum, DropsFramesThatFillNoSegment) {
  Random random(3);
  const Matrix<float> frames = noise(random, 40, 1);
  Matrix<float> longer(55, 1, 1000.0F);
  std::ranges::copy(frames.values(), longer.values().begin());
  SpectrumParameters parameters = every_bin(20);
  parameters.overlap = 0.0;
  EXPECT_EQ(Spectrum(parameters).apply(frames, 0.0).value(),
            Spectrum(parameters).apply(longer, 0.0).value());
}

TEST(Spectrum, IsLogarithmicAboveItsFloorOnRequest) {
  SpectrumParameters parameters;
  parameters.bands = 4;
  parameters.scale = SpectrumScale::kLogarithmic;
  parameters.floor = 0.5;
  Random random(4);
  const Matrix<float> frames = noise(random, 64, 1);
  const Signal logarithmic = Spectrum(parameters).apply(frames, 100.0).value();
  parameters.scale = SpectrumScale::kLinear;
  const Signal linear = Spectrum(parameters).apply(frames, 100.0).value();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(logarithmic.values()[i], std::log(0.5 + double{linear.values()[i]}), 1e-6);
  }
  parameters.scale = SpectrumScale::kLogarithmic;
  const Signal silent = Spectrum(parameters).apply(Matrix<float>(64, 1), 100.0).value();
  EXPECT_FLOAT_EQ(silent.values()[3], std::log(0.5F));
}

TEST(Spectrum, HasTheBinsOfThePaper) {
  const Spectrum spectrum(every_bin(4096));
  EXPECT_EQ(spectrum.bands(), 2049U);
  const Signal found = spectrum.apply(sine(1000.0, 8192.0, 8192), 8192.0).value();
  EXPECT_EQ(found.shape(), (std::vector<std::size_t>{1, 2049}));
  EXPECT_EQ(greatest_place(found.values()), 500U);
}

// Half the rate, where 'high' is automatic, and a rate from times that is a hair too low.
TEST(Spectrum, ReachesHalfTheFrameRate) {
  SpectrumParameters parameters;
  parameters.bands = 5;
  const Matrix<float> frames = sine(49.0, 100.0, 256);
  const Signal automatic = Spectrum(parameters).apply(frames, 100.0).value();
  EXPECT_EQ(greatest_place(automatic.values()), 4U);
  parameters.high = 50.0;
  EXPECT_EQ(Spectrum(parameters).apply(frames, 100.0).value(), automatic);
  EXPECT_TRUE(Spectrum(parameters).apply(frames, 99.99999));
}

TEST(Spectrum, RefusesBandsAboveHalfTheFrameRate) {
  SpectrumParameters parameters;
  parameters.high = 30.0;
  const Matrix<float> frames(64, 1);
  EXPECT_EQ(complaint(Spectrum(parameters).apply(frames, 50.0)),
            "bands from 0 to 30 Hz exceed the range that frames at 50 Hz can represent, 25 Hz");
  EXPECT_EQ(complaint(Spectrum(parameters).apply(frames, 50.0, 20.0)),
            "bands from 0 to 30 cycles/mm exceed the range that frames at 50 Hz and 20 mm/s can "
            "represent, "
            "1.25 cycles/mm");
  parameters.low = 25.0;
  parameters.high.reset();
  EXPECT_NE(complaint(Spectrum(parameters).apply(frames, 50.0)), "");
}

TEST(Spectrum, OfFramesAtSeveralRatesHasTheSameBandsWithACommonRate) {
  SpectrumParameters parameters;
  parameters.bands = 20;
  const auto band_at = [&](double rate) {
    const auto found = Spectrum(parameters).apply(sine(700.0, rate, 8192), rate);
    return found ? greatest_place(found->to_dense()) : 999;
  };
  EXPECT_EQ(band_at(8000.0), 3U);
  EXPECT_EQ(band_at(44100.0), 0U);
  parameters.rate = 8000.0;
  for (const double rate : {7700.0, 8000.0, 8300.0, 16000.0, 44100.0}) {
    EXPECT_EQ(band_at(rate), 3U) << rate;
  }
  EXPECT_EQ(complaint(Spectrum(parameters).apply(sine(1000.0, 7500.0, 8192), 7500.0)),
            "frames at 7500 Hz have other frequencies than those at 8000 Hz");
}

TEST(Spectrum, BinsOfAnotherRateAreRefused) {
  SpectrumParameters parameters = every_bin(64);
  parameters.rate = 8000.0;
  for (const double rate : {7700.0, 8000.0, 8300.0}) {
    EXPECT_TRUE(Spectrum(parameters).apply(sine(1000.0, rate, 640), rate)) << rate;
  }
  for (const double rate : {4000.0, 7500.0, 8500.0, 44100.0}) {
    EXPECT_NE(complaint(Spectrum(parameters).apply(sine(1000.0, rate, 640), rate)), "") << rate;
  }
}

TEST(Spectrum, RefusesAnUnknownRateOnlyForBands) {
  const Matrix<float> frames(64, 1);
  for (const double rate : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_EQ(complaint(Spectrum({}).apply(frames, rate)),
              "bands require the frame rate, which is unknown");
    EXPECT_TRUE(Spectrum(every_bin(64)).apply(frames, rate));
  }
}

TEST(Spectrum, RefusesASpeedThatIsNone) {
  SpectrumParameters parameters;
  parameters.high = 1.0;
  const Matrix<float> frames(64, 1);
  EXPECT_EQ(complaint(Spectrum(parameters).apply(frames, 50.0, 0.0)),
            "a spectrum cannot be divided by the speed 0");
  EXPECT_NE(complaint(Spectrum(parameters).apply(frames, 50.0, std::nan(""))), "");
  EXPECT_NE(complaint(Spectrum({}).apply(frames, 50.0, 5.0), ErrorKind::kUsage), "");
  EXPECT_NE(complaint(Spectrum(every_bin(8)).apply(frames, 50.0, 5.0), ErrorKind::kUsage), "");
}

TEST(Spectrum, RefusesTooFewAndTooManyFrames) {
  SpectrumParameters parameters = every_bin(16);
  EXPECT_EQ(complaint(Spectrum(parameters).apply(Matrix<float>(15, 1), 50.0)),
            "15 frames are too few for a spectrum of segments of 16");
  EXPECT_NE(complaint(Spectrum({}).apply(Matrix<float>(0, 1), 50.0)), "");
  parameters.segment_length.reset();
  parameters.transform_length = 16;
  EXPECT_TRUE(Spectrum(parameters).apply(Matrix<float>(16, 1), 50.0));
  EXPECT_EQ(complaint(Spectrum(parameters).apply(Matrix<float>(17, 1), 50.0)),
            "17 frames are too many for a transform of 16");
}

TEST(Spectrum, RefusesWhatIsNotFinite) {
  Matrix<float> frames(64, 3);
  frames(4, 1) = std::nanf("");
  EXPECT_EQ(complaint(Spectrum({}).apply(frames, 50.0)), "frame 5 contains nan in element 2");
}

TEST(Spectrum, RefusesParametersThatDoNotFit) {
  SpectrumParameters parameters;
  parameters.bands = 0;
  EXPECT_THROW(Spectrum{parameters}, InvalidArgument);
}

// 2 * 7 * 11 frames take the general butterfly, which works in the plan's scratch memory.
TEST(SpectrumThreads, GivesEveryThreadTheSame) {
  SpectrumParameters parameters = every_bin(154);
  parameters.transform_length = 154;
  const Spectrum spectrum(parameters);
  Random random(5);
  const Matrix<float> frames = noise(random, 3000, 4);
  const Signal single = spectrum.apply(frames, 0.0).value();
  std::vector<Signal> found(4);
  std::vector<std::thread> threads;
  threads.reserve(found.size());
  for (Signal& mine : found) {
    threads.emplace_back([&spectrum, &frames, &mine] {
      for (int i = 0; i < 5; ++i) mine = spectrum.apply(frames, 0.0).value();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Signal& mine : found) EXPECT_EQ(mine, single);
}

}  // namespace
}  // namespace somato
