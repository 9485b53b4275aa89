#include "maps/reading/sample_reader.h"

#include <utility>

#include "base/core/threads.h"
#include "maps/reading/winner_search.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// A map of some neurons of another one, in a row, for searches only.
Som map_of(const Som& som, const std::vector<std::size_t>& neurons) {
  SomParameters parameters = som.parameters();
  parameters.rows = 1;
  parameters.columns = neurons.size();
  parameters.lattice = Lattice::kRectangular;
  parameters.topology = Topology::kPlane;
  LaneMatrix<float> weights(neurons.size(), som.weights().columns());
  std::vector<float> row(weights.columns());
  for (std::size_t place = 0; place < neurons.size(); ++place) {
    som.weights().copy_row(neurons[place], row);
    for (std::size_t d = 0; d < row.size(); ++d) weights(place, d) = row[d];
  }
  return {std::move(parameters), std::move(weights), som.elements()};
}

// Whether the places are 0, 1, ..., count - 1.
bool are_all(std::span<const std::size_t> places, std::size_t count) {
  if (places.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (places[i] != i) return false;
  }
  return true;
}

}  // namespace

SampleReader::SampleReader(const Som& som, std::size_t threads, std::vector<std::size_t> candidates)
    : som_(som),
      threads_(threads),
      candidates_(std::move(candidates)),
      is_candidate_(candidates_.empty() ? 0 : som.neurons()) {
  for (const std::size_t neuron : candidates_) {
    require(neuron < som.neurons(), "a candidate is not on the map");
    is_candidate_[neuron] = true;
  }
}

SampleReadings SampleReader::read(const Samples& samples, ReadingChoice choice) {
  if (samples.count() == 0) return {};
  Samples storage;
  const Samples& seen = seen_samples(som_, samples, storage);
  SampleReadings readings;
  readings.winners = WinnerSearch::find_all(som_, seen, choice.second, threads_);
  if (choice.distance) readings.distances = distances(samples, readings.winners);
  if (!candidates_.empty()) readings.nearest = nearest(seen, readings.winners);
  return readings;
}

SampleReadings SampleReader::read(const Samples& samples, std::span<const std::size_t> places,
                                  ReadingChoice choice) {
  if (som_.knows(samples)) return read_known(samples, places, choice);
  if (are_all(places, samples.count())) return read(samples, choice);
  return read(samples.subset({places.begin(), places.end()}), choice);
}

SampleReadings SampleReader::read_known(const Samples& samples, std::span<const std::size_t> places,
                                        ReadingChoice choice) const {
  SampleReadings readings;
  readings.winners.resize(places.size());
  readings.distances.resize(choice.distance ? places.size() : 0);
  readings.nearest.resize(candidates_.empty() ? 0 : places.size());
  for_each_range(places.size(), threads_, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      const Winners winners = som_.winners(samples, places[i], workspace);
      readings.winners[i] = winners;
      if (choice.distance) {
        readings.distances[i] = som_.distance(samples, places[i], winners.first, workspace);
      }
      if (candidates_.empty()) continue;
      readings.nearest[i] = is_candidate(winners.first)
                                ? winners.first
                                : som_.winner_among(candidates_, samples, places[i], workspace);
    }
  });
  return readings;
}

std::vector<double> SampleReader::distances(const Samples& samples,
                                            const std::vector<Winners>& winners) const {
  std::vector<double> distances(samples.count());
  for_each_range(samples.count(), threads_, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = som_.distance(samples[i], winners[i].first, workspace);
    }
  });
  return distances;
}

// A winner that is a candidate is the most similar one: only the other samples are searched again.
std::vector<std::size_t> SampleReader::nearest(const Samples& seen,
                                               const std::vector<Winners>& winners) {
  std::vector<std::size_t> nearest(winners.size());
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    nearest[i] = winners[i].first;
    if (!is_candidate(nearest[i])) others.push_back(i);
  }
  if (others.empty()) return nearest;
  const std::vector<std::size_t> found = nearest_by_search(seen.subset(others));
  for (std::size_t i = 0; i < others.size(); ++i) nearest[others[i]] = found[i];
  return nearest;
}

std::vector<std::size_t> SampleReader::nearest_by_search(const Samples& seen) {
  if (!map_of_candidates_) map_of_candidates_ = map_of(som_, candidates_);
  std::vector<std::size_t> found;
  found.reserve(seen.count());
  for (const std::size_t place : winners_of_seen(*map_of_candidates_, seen, threads_)) {
    found.push_back(candidates_[place]);
  }
  return found;
}

void read_activity(const Som& som, const Samples& samples, std::size_t threads,
                   std::span<float> out) {
  const std::size_t neurons = som.neurons();
  require(out.size() == samples.count() * neurons, "activities need a value for each neuron");
  for_each_range(samples.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      som.activity(samples[i], workspace, out.subspan(i * neurons, neurons));
    }
  });
}

std::vector<std::size_t> first_winners(const SampleReadings& readings) {
  std::vector<std::size_t> first;
  first.reserve(readings.winners.size());
  for (const Winners& winners : readings.winners) first.push_back(winners.first);
  return first;
}

}  // namespace somato
