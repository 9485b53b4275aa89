#include "som/measured_rows.h"

#include <algorithm>
#include <span>
#include <utility>

#include "som/stoppable_rows.h"
#include "terminal/terminal.h"

namespace somato::program {

Result<SomMeasures> measure_rows(const MapAndRows& both, std::vector<SomMeasure> chosen,
                                 const MeasureParameters& parameters, std::size_t threads) {
  SomMeasurement measurement(both.model.som, both.rows.count, std::move(chosen), parameters,
                             threads);
  PreparedRows prepared(both.model, both.rows);
  StoppableRows rows(prepared.samples());
  return for_each_part(rows,
                       [&](const Samples& part) -> Result<void> {
                         measurement.add(part);
                         return {};
                       })
      .map([&] { return measurement.measures(both.rows.classes.of_sample); });
}

Result<void> measure_features(const MapAndRows& both, const std::vector<std::size_t>& winners,
                              FeatureMeasurement& measurement) {
  PreparedRows prepared(both.model, both.rows);
  StoppableRows rows(prepared.samples());
  std::span<const std::size_t> left(winners);
  return for_each_part(rows, [&](const Samples& part) -> Result<void> {
    measurement.add(part, left.first(part.count()));
    left = left.subspan(part.count());
    return {};
  });
}

std::vector<std::size_t> hits_of(const SomMeasures& measures) {
  std::vector<std::size_t> hits(measures.neurons.size());
  std::transform(measures.neurons.begin(), measures.neurons.end(), hits.begin(),
                 [](const NeuronMeasures& neuron) { return neuron.samples; });
  return hits;
}

std::string feature_name(const SomModel& model, std::size_t feature) {
  return model.features.empty() ? std::to_string(feature + 1) : model.features[feature];
}

}  // namespace somato::program
