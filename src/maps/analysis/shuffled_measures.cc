#include "somato/maps/som_measures.h"

#include <algorithm>
#include <utility>

#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Matrix<float> shuffled_dense(const Samples& samples, Random& random) {
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t d = 0; d < samples.size(); ++d) {
    const std::vector<std::size_t> places = random_order(samples.count(), random);
    for (std::size_t i = 0; i < samples.count(); ++i) rows(places[i], d) = samples[i].values[d];
  }
  return rows;
}

// Each column's values, with the rows in which they are.
using SparseColumns = std::vector<std::vector<std::pair<std::size_t, float>>>;

SparseColumns columns_of_sparse(const Samples& samples) {
  SparseColumns columns(samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const SignalView sample = samples[i];
    for (std::size_t v = 0; v < sample.values.size(); ++v) {
      columns[sample.indices[v]].emplace_back(i, sample.values[v]);
    }
  }
  return columns;
}

Samples shuffled_sparse(const Samples& samples, Random& random) {
  std::vector<std::vector<std::uint32_t>> indices(samples.count());
  std::vector<std::vector<float>> values(samples.count());
  const SparseColumns columns = columns_of_sparse(samples);
  for (std::size_t d = 0; d < columns.size(); ++d) {
    const std::vector<std::size_t> places = random_order(samples.count(), random);
    for (const auto& [row, value] : columns[d]) {
      indices[places[row]].push_back(static_cast<std::uint32_t>(d));
      values[places[row]].push_back(value);
    }
  }
  std::vector<Signal> rows;
  rows.reserve(samples.count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    rows.push_back(Signal::sparse({samples.size()}, std::move(indices[i]), std::move(values[i])));
  }
  return Samples::from_signals(rows);
}

}  // namespace

Samples with_shuffled_features(const Samples& samples, std::uint64_t seed) {
  Random random(seed, Stream::kAlterations);
  return samples.is_sparse() ? shuffled_sparse(samples, random)
                             : Samples(shuffled_dense(samples, random));
}

Result<std::vector<SomMeasures>> measure_shuffled(const Som& som, const Samples& samples,
                                                  const std::vector<SomMeasure>& chosen,
                                                  const MeasureParameters& parameters,
                                                  const std::vector<std::size_t>& classes,
                                                  std::size_t threads, const Progress& progress) {
  if (som.grid().graph() && parameters.shuffles > 0) {
    return fail(ErrorKind::kUsage, "a map that grows cannot be trained again on shuffled data",
                "shuffles", "use a map on rows and columns, or no shuffles");
  }
  if (!som.parameters().relevances.empty() && parameters.shuffles > 0) {
    return fail(ErrorKind::kUsage,
                "a map with relevances has a distance that shuffled maps do not learn", "shuffles",
                "use no shuffles, or a map that is refined by glvq");
  }
  TrainingOptions options;
  options.threads = threads;
  // Only whether to continue: a training is one step of this progress.
  std::size_t done = 0;
  if (progress) {
    options.progress = [&](std::uint64_t, std::uint64_t) {
      return progress(done, parameters.shuffles);
    };
  }
  std::vector<SomMeasures> measures;
  for (; done < parameters.shuffles; ++done) {
    const Samples shuffled = with_shuffled_features(samples, parameters.seed + done);
    SOMATO_TRY(const auto trained, train_som(som.parameters(), shuffled, options));
    measures.push_back(measure_som(trained, shuffled, chosen, parameters, classes, threads));
  }
  return measures;
}

}  // namespace somato
