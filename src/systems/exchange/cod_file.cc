#include "systems/exchange/cod_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/tables/csv_number.h"
#include "base/text/text.h"
#include "systems/exchange/map_array.h"

namespace somato {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::size_t kHeaderFields = 5;

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return fields;
}

// The lines of a text, counted from 1.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  std::optional<std::string_view> next() {
    if (rest_.empty()) return {};
    ++number_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return line;
  }

  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

std::optional<std::size_t> size_in(std::string_view field) {
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), size);
  const bool is_whole = error == std::errc() && end == field.data() + field.size() && size > 0;
  return is_whole ? std::optional(size) : std::nullopt;
}

std::optional<Lattice> lattice_in(std::string_view field) {
  if (field == "rect") return Lattice::kRectangular;
  if (field == "hexa") return Lattice::kHexagonal;
  return {};
}

bool is_header(const std::vector<std::string_view>& fields) {
  return fields.size() >= 2 && size_in(fields[0]) && lattice_in(fields[1]);
}

bool is_comment(const std::vector<std::string_view>& fields) {
  return fields.empty() || fields[0].starts_with('#');
}

// SOM Toolbox has shorter names for two functions.
std::optional<NeighbourhoodShape> neighbourhood_in(std::string_view field) {
  const std::string_view name = field == "cutgauss" ? "cut_gaussian"
                                : field == "ep"     ? "epanechnikov"
                                                    : field;
  for (const auto& [shape, its_name] : Choices<NeighbourhoodShape>::all()) {
    if (its_name == name) return shape;
  }
  return {};
}

class CodReader {
 public:
  CodReader(std::string_view text, const std::string& where, SomParameters parameters)
      : lines_(text), bytes_(text.size()), where_(where), parameters_(std::move(parameters)) {}

  Result<ImportedMap> read() {
    SOMATO_TRY_VOID(read_lines());
    if (!has_header_) return refuse("the file contains no map");
    if (units_ < *parameters_.rows * *parameters_.columns) {
      return refuse(fmt::format("the file ends after {} of {} units", units_,
                                *parameters_.rows * *parameters_.columns));
    }
    std::vector<std::string> features = names_of_features();
    const MapArray array{{*parameters_.rows, *parameters_.columns, weights_.columns()},
                         std::move(weights_)};
    SOMATO_TRY(auto model, map_of_weights(parameters_, array, std::move(features), where_));
    add_labels(model);
    return ImportedMap{std::move(model), std::move(notes_)};
  }

 private:
  tl::unexpected<Error> refuse(std::string what) const {
    return fail(ErrorKind::kData, std::move(what), fmt::format("{}:{}", where_, lines_.number()),
                "write the map again with SOM Toolbox or SOM_PAK");
  }

  Result<void> read_lines() {
    while (const auto line = lines_.next()) {
      const std::vector<std::string_view> fields = fields_of(*line);
      if (!fields.empty() && fields[0] == "#n") names_.assign(fields.begin() + 1, fields.end());
      if (is_comment(fields)) continue;
      SOMATO_TRY_VOID(has_header_ ? read_unit(fields) : read_header(fields));
    }
    return {};
  }

  Result<void> read_header(const std::vector<std::string_view>& fields) {
    if (!is_header(fields)) {
      return refuse("the first line is not the number of components and 'rect' or 'hexa'");
    }
    if (fields.size() != kHeaderFields) {
      return refuse(
          fmt::format("the first line has {} fields instead of {}: components, lattice, "
                      "sizes in x and y, neighbourhood",
                      fields.size(), kHeaderFields));
    }
    const auto columns = size_in(fields[2]);
    const auto rows = size_in(fields[3]);
    if (!columns || !rows) {
      return refuse(
          fmt::format("{} x {} is not the size of a map", shown(fields[2]), shown(fields[3])));
    }
    parameters_.rows = rows;
    parameters_.columns = columns;
    parameters_.lattice = *lattice_in(fields[1]);
    take_neighbourhood(fields[4]);
    return take_size(*size_in(fields[0]));
  }

  void take_neighbourhood(std::string_view field) {
    if (const auto shape = neighbourhood_in(field)) {
      parameters_.neighbourhood = *shape;
    } else {
      notes_.push_back(
          fmt::format("the neighbourhood {} is not known; further training would use {}",
                      shown(field), choice_name(parameters_.neighbourhood)));
    }
  }

  // A number and the blank behind it take two bytes: memory is not more than that of the file.
  Result<void> take_size(std::size_t components) {
    if (auto valid = Grid::validate(*parameters_.rows, *parameters_.columns, parameters_.lattice,
                                    parameters_.topology);
        !valid) {
      return refuse(valid.error().what);
    }
    const std::size_t units = *parameters_.rows * *parameters_.columns;
    if (components > (bytes_ + 1) / 2 / units) {
      return refuse(fmt::format("a file of {} bytes cannot contain {} x {} units of {} components",
                                bytes_, *parameters_.columns, *parameters_.rows, components));
    }
    weights_ = Matrix<float>(units, components);
    has_header_ = true;
    return {};
  }

  Result<void> read_unit(const std::vector<std::string_view>& fields) {
    if (units_ == weights_.rows()) {
      return refuse(fmt::format("the map has only {} units", weights_.rows()));
    }
    if (fields.size() < weights_.columns()) {
      return refuse(
          fmt::format("the line has {} numbers instead of {}", fields.size(), weights_.columns()));
    }
    for (std::size_t d = 0; d < weights_.columns(); ++d) {
      const auto reading = read_csv_number<float>(fields[d]);
      if (reading.meaning != CsvMeaning::kNumber) {
        return refuse(fmt::format("{} is not a finite number", shown(fields[d])));
      }
      weights_(units_, d) = reading.number;
    }
    take_labels(fields);
    ++units_;
    return {};
  }

  void take_labels(const std::vector<std::string_view>& fields) {
    if (fields.size() == weights_.columns()) return;
    units_with_labels_.push_back(units_);
    labels_.emplace_back(fields[weights_.columns()]);
    several_ += fields.size() > weights_.columns() + 1 ? 1 : 0;
  }

  std::vector<std::string> names_of_features() {
    if (names_.size() == weights_.columns()) return names_;
    if (!names_.empty()) {
      notes_.push_back(
          fmt::format("the {} names in the line #n are not used, because there are {} "
                      "components",
                      names_.size(), weights_.columns()));
    }
    return {};
  }

  void add_labels(SomModel& model) {
    if (several_ > 0) {
      notes_.push_back(
          fmt::format("units with several labels: {}; the first label of each is used", several_));
    }
    if (units_with_labels_.empty()) return;
    Classes classes = Classes::from_names(labels_);
    std::vector<std::optional<std::size_t>> class_of_unit(units_);
    for (std::size_t i = 0; i < units_with_labels_.size(); ++i) {
      class_of_unit[units_with_labels_[i]] = classes.of_sample[i];
    }
    model.classes = std::move(classes.names);
    model.labels = NeuronLabels(std::move(class_of_unit));
  }

  Lines lines_;
  std::size_t bytes_;
  const std::string& where_;
  SomParameters parameters_;
  bool has_header_ = false;
  std::size_t units_ = 0;
  std::size_t several_ = 0;
  Matrix<float> weights_;
  std::vector<std::size_t> units_with_labels_;
  std::vector<std::string> labels_;  // of these, the first of each
  std::vector<std::string> names_;
  std::vector<std::string> notes_;
};

}  // namespace

bool is_cod(std::string_view bytes) {
  Lines lines(bytes);
  while (const auto line = lines.next()) {
    const auto fields = fields_of(*line);
    if (!is_comment(fields)) return is_header(fields);
  }
  return false;
}

Result<ImportedMap> map_in_cod(std::string_view bytes, const std::string& where,
                               const SomParameters& parameters) {
  SOMATO_TRY(const std::string_view text, text_of(bytes, where));
  return CodReader(text, where, parameters).read();
}

}  // namespace somato
