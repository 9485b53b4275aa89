#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "interrupts.h"
#include "map.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/maps/clusters.h"
#include "somato/maps/som_features.h"
#include "somato/maps/som_measures.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

const std::string kMeasures = "SOM.measures";

std::vector<SomMeasure> measures_named(const std::vector<std::string>& names) {
  std::vector<SomMeasure> chosen;
  for (const std::string& name : names) {
    chosen.push_back(value_or_throw(choice_named<SomMeasure>("measure", name, kMeasures)));
  }
  return chosen;
}

// An array of one figure of each item.
template <typename Item, typename Figure>
nb::object column(const std::vector<Item>& items, Figure Item::* figure) {
  using Number = std::conditional_t<std::is_same_v<Figure, double>, double, std::int64_t>;
  std::vector<Number> numbers;
  numbers.reserve(items.size());
  for (const Item& item : items) numbers.push_back(static_cast<Number>(item.*figure));
  return array_of(std::move(numbers));
}

nb::dict columns_of(const std::vector<NeuronMeasures>& neurons) {
  nb::dict columns;
  columns["samples"] = column(neurons, &NeuronMeasures::samples);
  columns["share"] = column(neurons, &NeuronMeasures::share);
  columns["mean_distance"] = column(neurons, &NeuronMeasures::mean_distance);
  columns["greatest_distance"] = column(neurons, &NeuronMeasures::greatest_distance);
  return columns;
}

nb::dict columns_of(const std::vector<ClassMeasures>& classes) {
  nb::dict columns;
  columns["samples"] = column(classes, &ClassMeasures::samples);
  columns["neurons"] = column(classes, &ClassMeasures::neurons);
  columns["quantization_error"] = column(classes, &ClassMeasures::quantization_error);
  columns["purity"] = column(classes, &ClassMeasures::purity);
  columns["entropy"] = column(classes, &ClassMeasures::entropy);
  return columns;
}

nb::dict dict_of(const SomMeasures& measures) {
  nb::dict values;
  for (const auto& [measure, value] : measures.values) {
    values[choice_name(measure).c_str()] = value;
  }
  nb::dict all;
  all["values"] = values;
  all["ranked_samples"] = measures.ranked_samples;
  all["neurons"] = columns_of(measures.neurons);
  all["classes"] = columns_of(measures.classes);
  return all;
}

// `classes` has a number for each sample, or none.
nb::tuple measures(const Map& map, const SampleRows& rows, const Numbers<std::int64_t>& classes,
                   const std::vector<std::string>& names, const nb::dict& parameters,
                   std::size_t threads, nb::object progress) {
  const auto read = parameters_of<MeasureParameters>(parameters, kMeasures);
  const std::vector<SomMeasure> chosen = measures_named(names);
  const std::vector<std::size_t> numbers = sizes(classes);
  SomMeasures measured;
  Result<std::vector<SomMeasures>> shuffled;
  unlocked(
      [&](Interrupts& interrupts) {
        const Samples samples = map.inputs(rows);
        const Som& som = map.model().som;
        measured = measure_som(som, samples, chosen, read, numbers, threads);
        shuffled =
            measure_shuffled(som, samples, chosen, read, numbers, threads, interrupts.progress());
      },
      std::move(progress));
  nb::list by_chance;
  for (const SomMeasures& one : value_or_throw(std::move(shuffled))) by_chance.append(dict_of(one));
  return nb::make_tuple(dict_of(measured), by_chance);
}

Clusters clusters_of(const Map& map, const Numbers<std::int64_t>& labels) {
  Clusters clusters;
  clusters.of_neuron = sizes(labels);
  require(clusters.of_neuron.size() == map.model().som.neurons(), "each neuron needs a cluster");
  for (const std::size_t cluster : clusters.of_neuron) {
    clusters.count = std::max(clusters.count, cluster + 1);
  }
  return clusters;
}

nb::object linkage_of(const Clusters& clusters) {
  std::vector<double> rows;
  for (const ClusterMerge& merge : clusters.merges) {
    rows.insert(rows.end(), {static_cast<double>(merge.first), static_cast<double>(merge.second),
                             merge.height, static_cast<double>(merge.neurons)});
  }
  const std::size_t shape[] = {clusters.merges.size(), 4};
  return array_of(std::move(rows), shape);
}

// The cluster of each neuron, merges as a linkage of scipy, and the Davies-Bouldin index.
nb::tuple clusters(const Map& map, const nb::dict& parameters, const Numbers<std::int64_t>& hits) {
  const auto read = parameters_of<ClusterParameters>(parameters, "SOM.clusters");
  const std::vector<std::size_t> of_neurons = sizes(hits);
  const Som& som = map.model().som;
  Result<Clusters> found;
  double index = 0.0;
  {
    const nb::gil_scoped_release released;
    found = cluster_neurons(som, read, of_neurons);
    if (found) {
      index =
          davies_bouldin_index(som, *found, read.by_hits ? of_neurons : std::vector<std::size_t>());
    }
  }
  const Clusters clusters = read_or_throw(std::move(found));
  return nb::make_tuple(integers(clusters.of_neuron), linkage_of(clusters), index);
}

nb::dict cluster_samples(const Map& map, const Numbers<std::int64_t>& labels,
                         const Numbers<std::int64_t>& winners,
                         const Numbers<std::int64_t>& classes) {
  const std::vector<ClusterSamples> all = samples_of_clusters(
      map.model().som.grid(), clusters_of(map, labels), sizes(winners), sizes(classes));
  std::vector<std::int64_t> names;
  for (const ClusterSamples& of : all) {
    names.push_back(of.name ? static_cast<std::int64_t>(*of.name) : -1);
  }
  nb::dict columns;
  columns["neurons"] = column(all, &ClusterSamples::neurons);
  columns["regions"] = column(all, &ClusterSamples::regions);
  columns["samples"] = column(all, &ClusterSamples::samples);
  columns["name"] = array_of(std::move(names));
  columns["purity"] = column(all, &ClusterSamples::purity);
  return columns;
}

FeatureMeasurement measured_features(const Map& map, const SampleRows& rows,
                                     std::vector<std::size_t> groups, std::size_t threads) {
  const nb::gil_scoped_release released;
  const Samples samples = map.inputs(rows);
  const std::size_t count =
      groups.empty() ? 0 : *std::max_element(groups.begin(), groups.end()) + 1;
  FeatureMeasurement measurement(map.model().som, threads, std::move(groups), count);
  measurement.add(samples, measure_quality(map.model().som, samples, threads).winners);
  return measurement;
}

// The explained variance of each feature, the order of planes, and the group of each feature; the
// last two are empty if there are too many features.
nb::tuple features(const Map& map, const SampleRows& rows, std::size_t threads) {
  const std::vector<FeatureMeasures> all = measured_features(map, rows, {}, threads).features();
  PlaneOrder order;
  if (all.size() <= kMostPlanes) {
    const nb::gil_scoped_release released;
    order = order_planes(map.model().som);
  }
  return nb::make_tuple(column(all, &FeatureMeasures::explained_variance), integers(order.order),
                        integers(order.group_of_feature));
}

// For each group of neurons its features and their differences.
nb::list differences(const Map& map, const SampleRows& rows, const Numbers<std::int64_t>& groups,
                     std::size_t threads) {
  const std::vector<std::size_t> of_neurons = sizes(groups);
  const FeatureMeasurement measurement = measured_features(map, rows, of_neurons, threads);
  nb::list all;
  const std::size_t count = *std::max_element(of_neurons.begin(), of_neurons.end()) + 1;
  for (std::size_t group = 0; group < count; ++group) {
    const std::vector<FeatureDifference> of_group = measurement.differences(group);
    all.append(nb::make_tuple(column(of_group, &FeatureDifference::feature),
                              column(of_group, &FeatureDifference::difference)));
  }
  return all;
}

nb::tuple plane_order(const Map& map) {
  const PlaneOrder order = order_planes(map.model().som);
  return nb::make_tuple(integers(order.order), integers(order.group_of_feature));
}

}  // namespace

void bind_analysis(nb::module_& module) {
  module.def("measures", &measures, nb::arg("map"), nb::arg("rows"), nb::arg("classes").noconvert(),
             nb::arg("names"), nb::arg("parameters"), nb::arg("threads"),
             nb::arg("progress").none());
  module.def("clusters", &clusters, nb::arg("map"), nb::arg("parameters"),
             nb::arg("hits").noconvert());
  module.def("cluster_samples", &cluster_samples, nb::arg("map"), nb::arg("labels").noconvert(),
             nb::arg("winners").noconvert(), nb::arg("classes").noconvert());
  module.def("features", &features, nb::arg("map"), nb::arg("rows"), nb::arg("threads"));
  module.def("differences", &differences, nb::arg("map"), nb::arg("rows"),
             nb::arg("groups").noconvert(), nb::arg("threads"));
  module.def("plane_order", &plane_order, nb::arg("map"));
}

}  // namespace somato::python
