#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "som/row_output.h"
#include "somato/files/csv.h"
#include "somato/graph/som_model.h"
#include "somato/maps/layers.h"
#include "systems/model/complete_inputs.h"
#include "systems/signals/missing_values.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

// Predicts a layer of the rows of a table that need not have its columns.
class LayerPrediction {
 public:
  static Result<LayerPrediction> begin(const Arguments& arguments) {
    LayerPrediction prediction;
    prediction.path_ = arguments.text("MAP");
    SOMATO_TRY(prediction.model_, load_som_model(prediction.path_));
    SOMATO_TRY(prediction.missing_, read_missing(arguments));
    auto layer = layer_named(prediction.model_.som.parameters(), arguments.text("layer"));
    if (!layer) {
      layer.error().where = prediction.path_;
      return fail(std::move(layer.error()));
    }
    prediction.layer_ = std::move(*layer);
    return prediction;
  }

  Result<RowData> read(const Arguments& arguments) {
    const std::vector<ColumnScale> scales = model_.scales();
    auto rows = read_rows(arguments, of_others(model_.features), nullptr,
                          scales.size() > 1 ? of_others(scales) : scales);
    if (rows) SOMATO_TRY_VOID(check_fills_of(model_, *rows, path_));
    standardization_ = model_.standardization;
    model_.subtract_offsets();
    if (!rows || rows->size() == model_.som.input_size() - layer_.count) return rows;
    return fail(ErrorKind::kData,
                fmt::format("the data have {} columns, but the other layers {}", rows->size(),
                            model_.som.input_size() - layer_.count),
                rows->path, "use data without the columns of the layer, or skip them");
  }

  std::string head() const {
    std::string text = "sample";
    for (std::size_t d = 0; d < layer_.count; ++d) text += "," + csv_field(name_of(d));
    return text + ",greatest\n";
  }

  // With zeros for the columns of the layer, which have no effect.
  Samples inputs(const Samples& part) const {
    Matrix<float> rows(part.count(), som().input_size());
    std::vector<float> others(part.size());
    for (std::size_t i = 0; i < part.count(); ++i) {
      write_dense(part[i], others);
      const auto row = rows.row(i);
      const auto middle = others.begin() + static_cast<std::ptrdiff_t>(layer_.first);
      auto to = std::copy(others.begin(), middle, row.begin());
      to = std::fill_n(to, layer_.count, 0.0F);
      std::copy(middle, others.end(), to);
    }
    const Samples whole(std::move(rows));
    return model_.prepare(missing_ == MissingFill::kMean ? filled_with(model_.fill_values(), whole)
                                                         : whole);
  }

  // Predicts the layer of some inputs(), of which the first has the number `first`, from 0.
  std::string text_of(const Samples& part, std::size_t first, std::size_t threads) const {
    const Matrix<float> predicted = predict_layer(som(), layer_, part, threads);
    std::string text;
    for (std::size_t i = 0; i < predicted.rows(); ++i) {
      const auto row = predicted.row(i);
      text += fmt::format("{}", first + i + 1);
      for (std::size_t d = 0; d < row.size(); ++d) text += "," + number_of(d, row[d]);
      const auto greatest =
          static_cast<std::size_t>(std::max_element(row.begin(), row.end()) - row.begin());
      text += "," + csv_field(name_of(greatest)) + "\n";
    }
    return text;
  }

 private:
  const Som& som() const { return model_.som; }

  // Without the columns of the layer.
  template <typename T>
  std::vector<T> of_others(std::vector<T> all) const {
    if (all.empty()) return all;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(layer_.first);
    all.erase(first, first + static_cast<std::ptrdiff_t>(layer_.count));
    return all;
  }

  std::string name_of(std::size_t column) const {
    const std::size_t number = layer_.first + column;
    return model_.features.empty() ? std::to_string(number + 1) : model_.features[number];
  }

  // In the unit of the column, as precise as weights are; a standardized column may have an offset.
  std::string number_of(std::size_t column, float weight) const {
    const std::size_t element = layer_.first + column;
    const double number = in_units(standardization_, element, weight);
    const bool has_offset = standardization_ && standardization_->offsets()[element] != 0.0;
    return has_offset ? fmt::format("{:.12g}", number)
                      : fmt::format("{:.9g}", static_cast<float>(number));
  }

  std::string path_;
  SomModel model_;
  std::optional<Standardization> standardization_;  // with its offsets
  Layer layer_;
  MissingFill missing_ = MissingFill::kRefuse;
};

Result<void> predict(const Arguments& arguments) {
  SOMATO_TRY(const auto threads, threads_of(arguments, nullptr));
  SOMATO_TRY(auto prediction, LayerPrediction::begin(arguments));
  SOMATO_TRY(const auto rows, prediction.read(arguments));
  SOMATO_TRY(auto output, RowOutput::begin(arguments.text("output"), nullptr));
  std::size_t done = 0;
  SOMATO_TRY_VOID(output.commit(output.write(prediction.head()).and_then([&] {
    ChangedSamples inputs(rows.samples(),
                          [&](const Samples& part) { return prediction.inputs(part); });
    SamplesInRange in_range(inputs, rows.path, 0);
    return for_each_part(in_range, [&](const Samples& part) {
      const std::string text = prediction.text_of(part, done, threads);
      done += part.count();
      return output.write(text);
    });
  })));
  note_columns_and_filled(rows);
  return {};
}

}  // namespace

Command som_predict_command() {
  std::vector<Flag> flags{{"--layer", "The layer that is predicted from the others", true},
                          output_flag("-o,--output", "CSV file instead of standard output")};
  const std::vector<Flag> of_table = table_flags();
  flags.insert(flags.end(), of_table.begin(), of_table.end());
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  return {"som predict",
          "Predict a layer of each row from the other layers",
          {{"MAP", "A trained map with layers", true},
           data_positional("NPY file or text with the columns of the other layers")},
          std::move(flags),
          {},
          predict};
}

}  // namespace somato::program
