#include "recordings/ros/channel_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace somato {
namespace {

class Numbers : public FieldSink {
 public:
  explicit Numbers(std::vector<double>& values) : values_(&values) {}
  void take(const RosScalar& scalar, FieldPlace /*place*/) override {
    values_->push_back(scalar.number());
  }

 private:
  std::vector<double>* values_;
};

class PlacedNumbers : public FieldSink {
 public:
  PlacedNumbers(std::vector<double>& values, std::string& key) : values_(&values), key_(&key) {}
  void take(const RosScalar& scalar, FieldPlace place) override {
    values_->push_back(scalar.number());
    add_to_key(place, *key_);
  }

 private:
  std::vector<double>* values_;
  std::string* key_;
};

bool has_layout(const RosType& type) {
  const std::vector<RosField>& fields = type.root().fields;
  return !fields.empty() && fields.front().structure &&
         type.structures[*fields.front().structure].name == "std_msgs/MultiArrayLayout";
}

// The names that select elements: not the places of values without a name, and nothing if a name is
// not unique.
std::vector<std::string> selectable(const std::vector<std::string>& names,
                                    const std::string& field) {
  std::vector<std::string> selection;
  for (const std::string& name : names) {
    if (std::find(selection.begin(), selection.end(), name) != selection.end()) return {};
    if (!name.starts_with(field + "[")) selection.push_back(name);
  }
  return selection;
}

// The fields of the numbers of rows and columns in the message that contains the values.
std::vector<FieldReader> lengths_beside(const std::shared_ptr<const RosType>& type,
                                        const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::string before = dot == std::string::npos ? "" : path.substr(0, dot + 1);
  if (before.find('*') != std::string::npos || before.find("..") != std::string::npos) return {};
  for (const auto& [rows, columns] :
       {std::pair("rows", "cols"), std::pair("rows", "columns"), std::pair("height", "width")}) {
    auto down = FieldReader::compile(type, before + rows);
    auto across = FieldReader::compile(type, before + columns);
    if (!down || !across) continue;
    std::vector<FieldReader> lengths;
    lengths.push_back(std::move(*down));
    lengths.push_back(std::move(*across));
    return lengths;
  }
  return {};
}

Result<std::vector<double>> numbers_at(const FieldReader& reader, std::string_view message) {
  std::vector<double> values;
  Numbers sink(values);
  SOMATO_TRY_VOID(reader.read(message, sink));
  return values;
}

}  // namespace

Result<ChannelReader> ChannelReader::compile(const std::shared_ptr<const RosType>& type,
                                             const std::vector<std::string>& paths,
                                             const std::string& names) {
  if (paths.empty()) return fail(ErrorKind::kUsage, "there is no path to the values");
  ChannelReader reader;
  reader.values_.reserve(paths.size());
  for (const std::string& path : paths) {
    SOMATO_TRY(FieldReader values, FieldReader::compile(type, path));
    reader.values_.push_back(std::move(values));
  }
  SOMATO_TRY_VOID(reader.take_names(type, names));
  SOMATO_TRY_VOID(reader.check_selection());
  if (has_layout(*type) && paths == std::vector<std::string>{"data"}) {
    SOMATO_TRY(FieldReader lengths, FieldReader::compile(type, "layout.dim[*].size"));
    reader.lengths_.push_back(std::move(lengths));
    SOMATO_TRY(reader.offset_, FieldReader::compile(type, "layout.data_offset"));
  } else if (paths.size() == 1) {
    reader.lengths_ = lengths_beside(type, paths.front());
  }
  return reader;
}

Result<void> ChannelReader::take_names(const std::shared_ptr<const RosType>& type,
                                       const std::string& names) {
  const std::string paths = names.empty() ? usual_names(*type, values_.front()) : names;
  if (paths.empty()) return {};
  SOMATO_TRY(names_, MessageNames::compile(type, paths));
  return {};
}

Result<void> ChannelReader::check_selection() const {
  const auto selects = [](const FieldReader& path) { return !path.selected().empty(); };
  const auto count = std::count_if(values_.begin(), values_.end(), selects);
  if (count == 0) return {};
  if (static_cast<std::size_t>(count) < values_.size()) {
    return fail(ErrorKind::kUsage, "only some of the paths select elements by name", {},
                "select those of all paths by name, or of none");
  }
  if (names_) return {};
  return fail(ErrorKind::kUsage, "the messages have no names for these elements",
              values_.front().path(),
              "select elements by number, or state the field with their names as 'names' of the "
              "channel in a description");
}

ElementOrder ChannelReader::order() const {
  std::vector<std::string> selected;
  for (const FieldReader& path : values_) {
    for (const std::string& name : path.selected()) {
      selected.push_back(values_.size() > 1 ? element_of_path(path, name) : name);
    }
  }
  return ElementOrder(std::move(selected));
}

Result<void> ChannelReader::read(std::string_view message, std::vector<double>& values) const {
  values.clear();
  Numbers sink(values);
  for (const FieldReader& reader : values_) SOMATO_TRY_VOID(reader.read(message, sink));
  return leave_out_before_offset(message, values);
}

// With a key of the places of the values and their names, if these can vary.
Result<void> ChannelReader::read(std::string_view message, std::vector<double>& values,
                                 std::string& key) const {
  values.clear();
  Numbers numbers(values);
  PlacedNumbers placed(values, key);
  for (const FieldReader& reader : values_) {
    const bool is_simple = !names_ && !reader.has_varying_places();
    SOMATO_TRY_VOID(reader.read(message, is_simple ? static_cast<FieldSink&>(numbers) : placed));
  }
  if (names_) SOMATO_TRY_VOID(names_->add_to_key(message, key));
  return leave_out_before_offset(message, values);
}

Result<void> ChannelReader::leave_out_before_offset(std::string_view message,
                                                    std::vector<double>& values) const {
  if (!offset_) return {};
  SOMATO_TRY(const std::vector<double> offset, numbers_at(*offset_, message));
  const auto skipped = std::min(static_cast<std::size_t>(offset.front()), values.size());
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(skipped));
  return {};
}

Result<bool> ChannelReader::read(std::string_view message, ElementOrder& order,
                                 std::vector<double>& values) const {
  std::string key;
  SOMATO_TRY_VOID(read(message, values, key));
  if (values.empty()) return true;
  if (!order.is_known(key)) SOMATO_TRY_VOID(learn(message, key, order));
  return order.place(values);
}

Result<void> ChannelReader::learn(std::string_view message, const std::string& key,
                                  ElementOrder& order) const {
  SOMATO_TRY(const std::vector<std::string> names, element_names(message));
  Result<void> learnt = order.learn(key, names);
  if (learnt || !names_ || values_.size() > 1 || order.names().empty()) return learnt;
  if (learnt.error().advice.empty()) {
    const std::string field = values_.front().path_to_elements();
    std::vector<std::string> selection = selectable(order.names(), field);
    if (selection.empty()) selection = selectable(names, field);
    learnt.error().advice = fmt::format(
        "select the elements by name, so that other messages are left out: {}[{}]", field,
        selection.empty() ? "NAME" : fmt::format("{}", fmt::join(selection, ",")));
  }
  return learnt;
}

Result<std::vector<std::string>> ChannelReader::element_names(std::string_view message) const {
  std::vector<std::string> names;
  if (offset_) return names;
  if (names_) {
    SOMATO_TRY(names, names_->of(values_, message));
  }
  if (!names.empty()) return names;
  for (const FieldReader& reader : values_) {
    SOMATO_TRY(std::vector<std::string> more, reader.names(message));
    names.insert(names.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
  }
  return names;
}

Result<std::vector<std::size_t>> ChannelReader::shape(std::string_view message) const {
  using Shape = std::vector<std::size_t>;
  Shape shape;
  std::vector<double> lengths;
  for (const FieldReader& reader : lengths_) {
    SOMATO_TRY(const std::vector<double> more, numbers_at(reader, message));
    lengths.insert(lengths.end(), more.begin(), more.end());
  }
  const bool are_lists = !offset_ && lengths.size() > lengths_.size();
  if (lengths.size() < 2 || are_lists) return shape;
  std::vector<double> values;
  SOMATO_TRY_VOID(read(message, values));
  std::size_t elements = 1;
  for (const double length : lengths) {
    const bool is_possible = length >= 1.0 && length <= static_cast<double>(values.size()) &&
                             length == std::floor(length);
    if (!is_possible) return Shape();
    shape.push_back(static_cast<std::size_t>(length));
    elements = elements > values.size() ? 0 : elements * shape.back();
  }
  if (elements != values.size() || shape.size() < 2) shape.clear();
  return shape;
}

}  // namespace somato
