#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "som/map_and_rows.h"
#include "somato/maps/som_measures.h"

namespace somato::program {

/// The flag `--measures`, which selects measures of a map.
Flag measures_flag();

/// The request of the flag and of the parameters of measures.
struct MeasuresRequest {
  std::vector<SomMeasure> chosen;  ///< Measures of the whole map.
  bool neurons = false;            ///< Whether each neuron is measured.
  bool lists_neurons = false;      ///< Whether neurons are listed in the text as well.
  bool classes = false;            ///< Whether each class is measured.
  MeasureParameters parameters;

  bool any() const { return !chosen.empty() || neurons || classes; }
};

/// Errors (kUsage): an unknown measure, or parameters without the flag.
Result<MeasuresRequest> read_measures(const Arguments& arguments);

/// Adds the measures to the table of a result, of which it returns the text.
/// Errors: those of the file; of measure_shuffled(); kSystem if the rows of shuffled data are not
/// in memory; kUsage for classes without labels.
Result<std::string> add_measures(const MeasuresRequest& request, const MapAndRows& both,
                                 std::size_t threads, Table& table);

}  // namespace somato::program
