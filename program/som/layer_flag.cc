#include "som/layer_flag.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/tables/table_columns.h"
#include "base/text/text.h"
#include "som/column_report.h"
#include "somato/core/parameter.h"
#include "somato/core/value.h"
#include "somato/maps/layers.h"

namespace somato::program {
namespace {

const std::string kLayersFlag = "--layers";

tl::unexpected<Error> refuse_layer(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), kLayersFlag, std::move(advice));
}

std::string without_blanks(std::string text) {
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

Result<double> number_in_layer(const std::string& text, const std::string& layer) {
  std::size_t end = 0;
  double number = 0.0;
  try {
    number = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end > 0 && end == text.size()) return number;
  return refuse_layer(fmt::format("'{}' in layer '{}' is not a number", text, layer),
                      "write NAME=COLUMNS:DISTANCE:WEIGHT:SCALE");
}

// The features of a layer, by their places among all features.
Result<std::vector<std::size_t>> places_of_features(const std::string& columns,
                                                    const RowData& rows) {
  TableColumns table = rows.columns;
  table.features.clear();
  ColumnChoice choice;
  for (const std::string& item : split(columns, ',')) choice.use.push_back(without_blanks(item));
  SOMATO_TRY(const auto chosen, choose_columns(choice, std::move(table), kLayersFlag));
  std::vector<std::size_t> places;
  for (const std::size_t column : chosen.features) {
    const auto& features = rows.columns.features;
    const auto found = std::find(features.begin(), features.end(), column);
    if (found == features.end()) {
      return refuse_layer(fmt::format("column {} is in a layer, but not a feature",
                                      listed_columns(rows.columns, {column})),
                          "leave it out of the layers, or do not skip it");
    }
    places.push_back(static_cast<std::size_t>(found - features.begin()));
  }
  return places;
}

// NAME=COLUMNS[:DISTANCE[:WEIGHT[:SCALE]]]
Result<Layer> read_layer(const std::string& text, const RowData& rows) {
  const std::size_t equals = text.find('=');
  std::vector<std::string> parts =
      split(equals == std::string::npos ? "" : text.substr(equals + 1), ':');
  constexpr std::size_t kMostParts = 4;
  if (equals == std::string::npos || parts.size() > kMostParts ||
      without_blanks(parts[0]).empty()) {
    return refuse_layer(fmt::format("'{}' is not a layer", text),
                        "write NAME=COLUMNS, or NAME=COLUMNS:DISTANCE:WEIGHT:SCALE");
  }
  Layer layer;
  layer.name = without_blanks(text.substr(0, equals));
  SOMATO_TRY(const auto places, places_of_features(parts[0], rows));
  layer.first = *std::min_element(places.begin(), places.end());
  layer.count = places.size();
  const std::size_t last = *std::max_element(places.begin(), places.end());
  if (last - layer.first + 1 != layer.count) {
    return refuse_layer(fmt::format("the columns of layer '{}' are not neighbours", layer.name),
                        "put the columns of a layer next to each other in the table");
  }
  if (parts.size() > 1 && !without_blanks(parts[1]).empty()) {
    SOMATO_TRY(layer.similarity,
               choice_named<Similarity>("distance", without_blanks(parts[1]), kLayersFlag));
  }
  if (parts.size() > 2 && !without_blanks(parts[2]).empty()) {
    SOMATO_TRY(layer.weight, number_in_layer(without_blanks(parts[2]), layer.name));
  }
  if (parts.size() > 3) {
    SOMATO_TRY(layer.scale, number_in_layer(without_blanks(parts[3]), layer.name));
  }
  return layer;
}

Result<std::vector<Layer>> checked_layers(std::vector<Layer> layers, std::size_t elements) {
  SomParameters parameters;
  parameters.layers = std::move(layers);
  auto fits = check_layers(parameters, elements);
  if (fits) return std::move(parameters.layers);
  fits.error().where = kLayersFlag;
  return fail(std::move(fits.error()));
}

}  // namespace

Flag layers_flag() {
  return {
      kLayersFlag,
      "Groups of columns with a distance each, such as "
      "'shape=a,b,c;touch=t_*:manhattan:2': NAME=COLUMNS, then optionally the distance "
      "(euclidean by default), the weight (1) and the distance that counts as 1 (the mean "
      "distance of rows), separated by colons. A name with one of ,:;= is written as a pattern, "
      "such as f?x"};
}

Result<std::vector<Layer>> read_layers(const Arguments& arguments, const RowData& rows) {
  std::vector<Layer> layers;
  if (!arguments.has("layers")) return layers;
  for (const std::string& text : split(arguments.text("layers"), ';')) {
    if (without_blanks(text).empty()) continue;
    SOMATO_TRY(auto layer, read_layer(text, rows));
    layers.push_back(std::move(layer));
  }
  if (layers.empty()) return refuse_layer("there is no layer", "write NAME=COLUMNS");
  std::sort(layers.begin(), layers.end(),
            [](const Layer& a, const Layer& b) { return a.first < b.first; });
  std::size_t end = 0;
  for (const Layer& layer : layers) {
    if (layer.first > end) break;
    if (layer.first < end) {
      return refuse_layer(
          fmt::format("a column of layer '{}' is in another layer, too", layer.name),
          "put each column into one layer");
    }
    end += layer.count;
  }
  if (end == rows.size()) return checked_layers(std::move(layers), end);
  return refuse_layer(fmt::format("column {} is in no layer",
                                  listed_columns(rows.columns, {rows.columns.features[end]})),
                      "put it into a layer, or leave it out with --skip");
}

}  // namespace somato::program
