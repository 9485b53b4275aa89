#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/core/threads.h"
#include "errors.h"
#include "interrupts.h"
#include "map.h"
#include "maps/reading/sample_reader.h"
#include "maps/reading/weight_plane.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "somato/maps/contributions.h"
#include "somato/maps/layers.h"
#include "somato/maps/som_quality.h"
#include "systems/model/complete_inputs.h"

namespace somato::python {

namespace nb = nanobind;

namespace {

// Whether a value of another layer than this one is known.
Result<void> check_known_beside(std::span<const float> row, const Layer& layer,
                                std::size_t number) {
  for (std::size_t d = 0; d < row.size(); ++d) {
    const bool is_of_layer = d >= layer.first && d < layer.first + layer.count;
    if (!is_of_layer && !std::isnan(row[d])) return {};
  }
  return fail(ErrorKind::kData, fmt::format("row {} has no known value of another layer", number),
              "X", "leave the row out");
}

}  // namespace

// Missing values of other layers are left out of the distance.
nb::object Map::predict_layer(const SampleRows& rows, const std::string& name,
                              std::size_t threads) const {
  check_rows(rows);
  const Layer layer = value_or_throw(layer_named(model_.som.parameters(), name));
  std::vector<double> predicted(rows.count() * layer.count);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(rows, interrupts, [&](Samples part, std::size_t first) {
      const bool fills = rows.missing() == MissingFill::kMean;
      if (!fills) part = taking(rows).prepare(rows.part(first, part.count()));
      for (std::size_t i = 0; i < part.count(); ++i) {
        value_or_throw(check_known_beside(part[i].values, layer, first + i));
      }
      const Matrix<float> found = somato::predict_layer(model_.som, layer, part, threads);
      for (std::size_t i = 0; i < found.rows(); ++i) {
        for (std::size_t d = 0; d < layer.count; ++d) {
          predicted[(first + i) * layer.count + d] =
              in_units(model_.standardization, layer.first + d, found(i, d));
        }
      }
    });
  });
  const std::size_t shape[] = {rows.count(), layer.count};
  return array_of(std::move(predicted), shape);
}

nb::object Map::activity(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const std::size_t neurons = model_.som.neurons();
  const std::size_t shape[] = {rows.count(), neurons};
  auto [array, activity] = new_array<float>(shape);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(rows, interrupts, [&](const Samples& part, std::size_t first) {
      read_activity(model_.som, part, threads,
                    activity.subspan(first * neurons, part.count() * neurons));
    });
  });
  return array;
}

template <typename NumbersOf>
nb::object Map::numbers_of(const SampleRows& rows, NumbersOf numbers_of_part) const {
  check_rows(rows);
  std::vector<std::int64_t> numbers(rows.count());
  unlocked([&](Interrupts& interrupts) {
    for_each_part(rows, interrupts, [&](const Samples& part, std::size_t first) {
      const std::vector<std::size_t> of_part = numbers_of_part(part);
      std::copy(of_part.begin(), of_part.end(),
                numbers.begin() + static_cast<std::ptrdiff_t>(first));
    });
  });
  return array_of(std::move(numbers));
}

nb::object Map::winners(const SampleRows& rows, std::size_t threads) const {
  SampleReader reader(model_.som, threads);
  return numbers_of(rows, [&](const Samples& part) { return first_winners(reader.read(part)); });
}

nb::object Map::classes(const SampleRows& rows, std::size_t threads) const {
  return numbers_of(
      rows, [&](const Samples& part) { return model_.labels.classify(model_.som, part, threads); });
}

nb::object Map::labelled_winners(const SampleRows& rows, std::size_t threads) const {
  SampleReader reader(model_.som, threads, model_.labels.labelled());
  return numbers_of(rows, [&](const Samples& part) { return reader.read(part).nearest; });
}

// Missing values are filled for the choice of the neurons only.
nb::tuple Map::contributions(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const Som& som = model_.som;
  const std::size_t columns = som.input_size();
  std::vector<std::int64_t> neurons(2 * rows.count());
  std::vector<double> distances(2 * rows.count());
  std::vector<double> values(rows.count() * columns);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(rows, interrupts, [&](const Samples& part, std::size_t first) {
      const auto deciding = deciding_neurons(som, model_.labels, part, threads);
      const Samples known = taking(rows).prepare(rows.part(first, part.count()));
      for_each_range(part.count(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Contributions found = somato::contributions(som, known[i], deciding[i]);
          const std::size_t row = first + i;
          neurons[2 * row] = static_cast<std::int64_t>(deciding[i].nearest);
          neurons[2 * row + 1] = static_cast<std::int64_t>(deciding[i].other);
          distances[2 * row] = found.of_nearest;
          distances[2 * row + 1] = found.of_other;
          const auto listed = som.elements().listed();
          for (std::size_t place = 0; place < found.values.size(); ++place) {
            const std::size_t column = listed.empty() ? place : listed[place];
            values[row * columns + column] = found.values[place];
          }
        }
      });
    });
  });
  const std::size_t pairs[] = {rows.count(), 2};
  const std::size_t shape[] = {rows.count(), columns};
  return nb::make_tuple(array_of(std::move(neurons), pairs), array_of(std::move(distances), pairs),
                        array_of(std::move(values), shape));
}

nb::object Map::plane_positions(const SampleRows& rows) const {
  check_rows(rows);
  std::vector<double> coordinates;
  coordinates.reserve(2 * rows.count());
  unlocked([&](Interrupts& interrupts) {
    const WeightPlane plane(model_.som);
    for_each_part(rows, interrupts, [&](const Samples& part, std::size_t /*first*/) {
      for (const Position& at : plane.positions_of(model_.som, part)) {
        coordinates.insert(coordinates.end(), {at.x, at.y});
      }
    });
  });
  const std::size_t shape[] = {rows.count(), 2};
  return array_of(std::move(coordinates), shape);
}

nb::tuple Map::quality(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  SomQuality quality;
  std::vector<std::int64_t> winners;
  winners.reserve(rows.count());
  unlocked([&](Interrupts& interrupts) {
    SomQualityMeasurement measurement(model_.som, threads);
    for_each_part(rows, interrupts, [&](const Samples& part, std::size_t /*first*/) {
      const auto found = measurement.add(part);
      winners.insert(winners.end(), found.begin(), found.end());
    });
    quality = measurement.quality();
  });
  return nb::make_tuple(quality.quantization_error, quality.topographic_error,
                        integers(quality.hits), array_of(std::move(winners)));
}

nb::object Map::distances(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const std::size_t neurons = model_.som.neurons();
  std::vector<double> distances(rows.count() * neurons);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(rows, interrupts, [&](const Samples& part, std::size_t first) {
      for_each_range(part.count(), threads, [&](std::size_t begin, std::size_t end) {
        SomWorkspace workspace;
        for (std::size_t i = begin; i < end; ++i) {
          double* const of_row = distances.data() + (first + i) * neurons;
          for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
            of_row[neuron] = model_.som.distance(part[i], neuron, workspace);
          }
        }
      });
    });
  });
  const std::size_t shape[] = {rows.count(), neurons};
  return array_of(std::move(distances), shape);
}

}  // namespace somato::python
