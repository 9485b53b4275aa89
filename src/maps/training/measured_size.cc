#include "somato/maps/measured_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/core/threads.h"
#include "maps/analysis/paired_errors.h"
#include "maps/som/fill_from_winner.h"
#include "maps/som/initial_weights.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr std::size_t kHeldOut = 5;         // one of so many samples is held out in turn
constexpr std::size_t kLeastHeldOut = 500;  // of few samples, more are held out one after another
constexpr std::size_t kMostSamplesOfNeuron = 16;  // of the smallest map
constexpr std::size_t kLeastMeasured = 50;        // samples: fewer than ten decide nothing
constexpr std::size_t kMostMeasured = 2500;       // samples
constexpr std::uint64_t kEpochs = 100;
constexpr std::uint64_t kEpochsOfCheck = 20;
constexpr double kMeasuredTolerance = 0.001;
constexpr double kLeastMeasuredGain = 1e-4;  // of the distance from a single neuron, above rounding
constexpr double kRadiusStart = 0.125;       // of the longer side
constexpr double kRadiusEnd = 0.2;           // neighbours then learn less than 1e-5 of the winner
constexpr double kLargest = 50.0;            // neurons, times the root of the samples

// The numbers of the samples that are learned, and of those that are held out.
struct Division {
  std::vector<std::size_t> learned;
  std::vector<std::size_t> held_out;
};

// Samples are held out in random order, because those of a table may be in a regular one.
Division divided(const std::vector<std::size_t>& places, std::size_t fold) {
  Division division;
  for (std::size_t i = 0; i < places.size(); ++i) {
    (places[i] % kHeldOut == fold ? division.held_out : division.learned).push_back(i);
  }
  return division;
}

// The same for every seed of a map.
std::vector<std::size_t> random_places(std::size_t count) {
  Random random(1, Stream::kGroupings);
  return random_order(count, random);
}

// As many divisions as hold kLeastHeldOut samples out, at most all: the standard error of a few
// samples would hide what more neurons gain.
std::vector<Division> divisions(std::size_t count) {
  const std::vector<std::size_t> places = random_places(count);
  std::vector<Division> all;
  std::size_t held_out = 0;
  for (std::size_t fold = 0; fold < kHeldOut && held_out < kLeastHeldOut; ++fold) {
    all.push_back(divided(places, fold));
    held_out += all.back().held_out.size();
  }
  return all;
}

double distance_of(const Som& som, const Samples& samples, std::size_t sample,
                   SomWorkspace& workspace) {
  if (som.knows(samples)) {
    return som.distance(samples, sample, som.winners(samples, sample, workspace).first, workspace);
  }
  return som.distance(samples[sample], som.winner(samples[sample], workspace), workspace);
}

std::vector<double> distances_of(const Som& som, const Samples& samples,
                                 const std::vector<std::size_t>& numbers, std::size_t threads) {
  std::vector<double> distances(numbers.size());
  for_each_range(numbers.size(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = distance_of(som, samples, numbers[i], workspace);
    }
  });
  return distances;
}

// A share of neurons, and the distances of the samples that are held out.
struct TriedSize {
  double share = 1.0;
  std::size_t neurons = 0;
  std::vector<double> distances;

  double error() const {
    return std::accumulate(distances.begin(), distances.end(), 0.0) /
           static_cast<double>(distances.size());
  }
};

// The least share than which the best one is not better by more than one standard error and by more
// than `least_gain`.
double smallest_sufficient(const std::vector<TriedSize>& tried, double least_gain) {
  const auto best = std::ranges::min_element(tried, {}, &TriedSize::error);
  return std::ranges::find_if(tried,
                              [&](const TriedSize& one) {
                                return one.error() - best->error() <= least_gain ||
                                       !is_clearly_better(best->distances, one.distances);
                              })
      ->share;
}

std::size_t columns_of(double neurons, std::size_t rows) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(neurons / static_cast<double>(rows)));
}

// An approximately square grid of at most so many neurons, unless the grid needs two rows.
SomParameters sized(const SomParameters& parameters, double neurons) {
  auto [rows, columns] = sides_of(neurons);
  const bool must_be_even =
      parameters.lattice == Lattice::kHexagonal && parameters.topology == Topology::kTorus;
  if (must_be_even && rows % 2 == 1) {
    rows = std::max<std::size_t>(2, rows - 1);
    columns = columns_of(neurons, rows);
  }
  return with_size(parameters, rows, columns);
}

SomParameters of_check(const SomParameters& parameters, double neurons) {
  SomParameters changed = sized(parameters, neurons);
  changed.epochs = kEpochsOfCheck;
  changed.tolerance = 0.0;
  return changed;
}

Result<TriedSize> tried_size(const SomParameters& parameters, const Samples& samples,
                             const std::vector<Division>& divisions, double share,
                             const SizeOptions& options) {
  TriedSize tried{share, 0, {}};
  for (const Division& division : divisions) {
    if (options.proceed) SOMATO_TRY_VOID(options.proceed());
    const double neurons = share * static_cast<double>(division.learned.size());
    SOMATO_TRY(const Som som,
               train_som(of_check(parameters, std::max(1.0, neurons)), samples,
                         {.threads = options.threads, .training = division.learned}));
    tried.neurons = std::max(tried.neurons, som.neurons());
    const auto distances = distances_of(som, samples, division.held_out, options.threads);
    tried.distances.insert(tried.distances.end(), distances.begin(), distances.end());
  }
  return tried;
}

// Those that are measured.
Samples drawn(const Samples& samples) {
  if (samples.count() <= kMostMeasured) return samples;
  std::vector<std::size_t> numbers = random_places(samples.count());
  numbers.resize(kMostMeasured);
  std::ranges::sort(numbers);
  return samples.subset(numbers);
}

Result<void> check_measurable(const SomParameters& parameters, const Samples& samples) {
  if (parameters.neighbourhood == NeighbourhoodShape::kMexicanHat) {
    return fail(ErrorKind::kUsage,
                "a map of measured size learns in batches, which cannot use the neighbourhood "
                "mexican_hat",
                "neighbourhood", "choose another 'neighbourhood', or give 'rows' and 'columns'");
  }
  if (!has_missing(samples)) return {};
  return fail(ErrorKind::kData,
              "the size of a map is measured by complete samples, and values are missing", "size",
              "fill the missing values, or give 'rows' and 'columns'");
}

}  // namespace

const std::vector<std::pair<SizeChoice, std::string>>& Choices<SizeChoice>::all() {
  static const std::vector<std::pair<SizeChoice, std::string>> choices{
      {SizeChoice::kByNumber, "by_number"}, {SizeChoice::kMeasured, "measured"}};
  return choices;
}

const Declarations<SizeParameters>& SizeParameters::declarations() {
  static const auto declared = Declarations<SizeParameters>().add(
      "size", &SizeParameters::size, "", Range::any(),
      "How the size is decided where rows and columns are not given: by_number of the samples, or "
      "measured: as many neurons as lower the distance of samples that are not learned, up to as "
      "many as samples (fewer than 50 get as many), trained in batches until nothing improves. "
      "Measured maps classify better "
      "and are less suitable for looking at. Our choice; docs/decisions/0040-automatic-size.md.");
  return declared;
}

std::string reason_without_effect(SizeChoice size, std::string_view name) {
  constexpr std::array kDecided{
      "rows",       "columns",           "initial_weights", "training",        "iterations",
      "epochs",     "tolerance",         "draws",           "radius_schedule", "radius_start",
      "radius_end", "radius_reached_at", "patience",        "most_checks"};
  const bool is_decided =
      std::ranges::find(kDecided, name) != kDecided.end() || name.starts_with("learning_rate");
  return size == SizeChoice::kMeasured && is_decided ? "the size is measured" : "";
}

Result<MeasuredSize> measured_size(const SomParameters& parameters, const Samples& samples,
                                   const SizeOptions& options) {
  if (samples.count() < kLeastMeasured) return MeasuredSize{};
  const std::vector<Division> all = divisions(samples.count());
  SOMATO_TRY(const TriedSize single, tried_size(parameters, samples, all, 0.0, options));
  MeasuredSize measured;
  std::vector<TriedSize> tried;
  for (std::size_t samples_of_neuron = kMostSamplesOfNeuron; samples_of_neuron > 0;
       samples_of_neuron /= 2) {
    const double share = 1.0 / static_cast<double>(samples_of_neuron);
    SOMATO_TRY(TriedSize one, tried_size(parameters, samples, all, share, options));
    measured.checks.push_back({one.neurons, one.error()});
    tried.push_back(std::move(one));
  }
  measured.share = smallest_sufficient(tried, kLeastMeasuredGain * single.error());
  return measured;
}

double most_neurons(std::size_t samples) {
  const auto count = static_cast<double>(samples);
  return std::min(count, kLargest * std::sqrt(count));
}

std::pair<std::size_t, std::size_t> sides_of(double neurons) {
  const auto rows = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(neurons)));
  return {rows, columns_of(neurons, rows)};
}

SomParameters with_size(SomParameters parameters, std::size_t rows, std::size_t columns) {
  require(rows > 0 && columns > 0, "a map has at least one neuron");
  SomParameters& p = parameters;
  p.rows = rows;
  p.columns = columns;
  p.initial_weights = InitialWeights::kLinear;
  p.training = Training::kBatch;
  p.iterations.reset();
  p.epochs = kEpochs;
  p.tolerance = kMeasuredTolerance;
  p.radius_schedule = ScheduleShape::kExponential;
  p.radius_start = std::max(1.0, kRadiusStart * static_cast<double>(std::max(rows, columns)));
  p.radius_end = kRadiusEnd;
  p.radius_reached_at.reset();
  return parameters;
}

Result<SizedParameters> sized_by_measurement(const SomParameters& parameters,
                                             const Samples& samples, const SizeOptions& options) {
  SOMATO_TRY_VOID(check_measurable(parameters, samples));
  SOMATO_TRY(const MeasuredSize size, measured_size(parameters, drawn(samples), options));
  const auto count = static_cast<double>(samples.count());
  const double neurons = std::min(size.share * count, most_neurons(samples.count()));
  SomParameters found = sized(parameters, std::max(1.0, neurons));
  const bool has_plane = check_initial_weights(found, samples).has_value();
  if (!has_plane) found.initial_weights = InitialWeights::kSamples;
  return SizedParameters{std::move(found), size};
}

}  // namespace somato
