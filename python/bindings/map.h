#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "arrays.h"
#include "interrupts.h"
#include "nanobind/nanobind.h"
#include "sample_rows.h"
#include "somato/graph/som_model.h"

namespace somato::python {

/// A trained map, as the program's model files contain it. Its functions take rows that are not
/// copied, release the lock of the interpreter while they compute, and run signal handlers in
/// between. They throw Failure (kData) for rows of another number of columns and for rows outside
/// the range of the map.
class Map {
 public:
  explicit Map(SomModel model);

  /// Trains a map. `parameters` may contain all parameters of a SOM; throws Failure as train_som()
  /// and for a parameter that differs from its default without an effect. `progress` is as for
  /// Interrupts.
  static Map train(const nanobind::dict& parameters, const SampleRows& rows, std::size_t threads,
                   nanobind::object progress);

  /// The parameters of a map of measured size for the rows, and the checks: pairs of a number of
  /// neurons and a mean distance. Throws Failure as sized_by_measurement(), and for parameters
  /// that the size decides.
  static nanobind::tuple sized(const nanobind::dict& parameters, const SampleRows& rows,
                               std::size_t threads);

  /// The initial map for rows.
  static Map initial(const nanobind::dict& parameters, const SampleRows& rows);

  /// The map with `weights` of (neurons, features), which stand in an array of `shape`; see
  /// map_of_weights().
  static Map of_weights(const nanobind::dict& parameters, const Rows& weights,
                        const std::vector<std::uint64_t>& shape, std::vector<std::string> features);

  /// The map in a file that import_map() reads, and its notes.
  static nanobind::tuple imported(const std::string& path, const nanobind::dict& parameters,
                                  std::vector<std::string> features, const std::string& variable);

  /// A copy of the map that has learned the rows once each, in their order, after the samples that
  /// it has seen.
  Map learned(const SampleRows& rows, std::size_t threads) const;

  /// A copy of the map that labels have refined, and a dictionary with its order before and after.
  /// `classes` has the class of each row, or -1 without one; `parameters` may contain all
  /// parameters of a refinement. Throws Failure as refine_som().
  nanobind::tuple refined(const SampleRows& rows, const Numbers<std::int64_t>& classes,
                          const nanobind::dict& parameters, std::size_t threads,
                          nanobind::object progress) const;

  /// A copy of the map whose neurons are named by the classes of their samples.
  Map labelled(const std::vector<std::string>& names, const Numbers<std::int64_t>& winners,
               const Numbers<std::int64_t>& classes) const;

  /// A copy of the map with names of its columns.
  Map named(std::vector<std::string> features) const;

  nanobind::object winners(const SampleRows& rows, std::size_t threads) const;
  nanobind::object activity(const SampleRows& rows, std::size_t threads) const;
  nanobind::object classes(const SampleRows& rows, std::size_t threads) const;

  /// The most similar neuron with a label.
  nanobind::object labelled_winners(const SampleRows& rows, std::size_t threads) const;

  /// For the two labelled neurons that decide the class of each row, (rows, 2): their numbers,
  /// their distances, and the contributions of the columns, (rows, columns), in which missing
  /// values have none.
  nanobind::tuple contributions(const SampleRows& rows, std::size_t threads) const;

  /// Quantization error, topographic error, hits and winners.
  nanobind::tuple quality(const SampleRows& rows, std::size_t threads) const;

  /// The coordinates of rows in the plane of the map's principal components: float64 of (rows, 2).
  nanobind::object plane_positions(const SampleRows& rows) const;

  /// All rows as inputs of the map.
  Samples inputs(const SampleRows& rows) const;

  /// The offset of each column that is subtracted before numbers are rounded; empty if all are 0.
  std::vector<double> offsets() const;

  /// The deviation of each column that is known; see SomModel::scales().
  const std::vector<double>& deviations() const;

  /// The distance of each row from each neuron; float64 of (rows, neurons).
  nanobind::object distances(const SampleRows& rows, std::size_t threads) const;

  /// The first column of a layer and their number; throws Failure if there is none of this name.
  nanobind::tuple layer_columns(const std::string& layer) const;

  /// The layer's columns predicted from the others: (rows, columns).
  nanobind::object predict_layer(const SampleRows& rows, const std::string& layer,
                                 std::size_t threads) const;

  /// (name, columns, distance, weight, scale) of each layer.
  nanobind::list layers() const;

  /// In the unit of the rows; float32 of (neurons, columns).
  nanobind::object weights() const;

  /// The relevances of the columns, float64; None without.
  nanobind::object relevances() const;

  /// The positions of the neurons on the map; float64 of (neurons, 2).
  nanobind::object positions() const;

  nanobind::object u_matrix() const;

  /// The corners of each neuron's cell in a picture, clockwise, in widths of a cell: (neurons, 4 or
  /// 6, 2).
  nanobind::object cells() const;

  const SomModel& model() const { return model_; }

  /// The iterations or epochs that train() has made; 0 for other maps.
  std::uint64_t steps() const { return steps_; }

 private:
  void check_rows(const SampleRows& rows) const;

  // numbers_of_part(samples) for parts of the rows as inputs of the map.
  template <typename NumbersOf>
  nanobind::object numbers_of(const SampleRows& rows, NumbersOf numbers_of_part) const;

  // Calls `work` with parts of the rows as inputs of the map, and the number of the part's first
  // row.
  void for_each_part(const SampleRows& rows, Interrupts& interrupts,
                     const std::function<void(const Samples&, std::size_t first)>& work) const;

  // That which takes the rows.
  const SomModel& taking(const SampleRows& rows) const;

  SomModel model_;
  std::uint64_t steps_ = 0;
  std::optional<SomModel> moved_;           // the same without offsets, if it has offsets
  mutable std::vector<double> deviations_;  // once they have been used
};

/// Throws Failure for parameters of a refinement with which a map of these parameters cannot be
/// refined.
void check_map_refinement(const nanobind::dict& refinement, const nanobind::dict& som);

}  // namespace somato::python
