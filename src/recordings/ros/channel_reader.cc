#include "recordings/ros/channel_reader.h"

#include <algorithm>
#include <utility>

namespace somato {
namespace {

class Numbers : public FieldSink {
 public:
  explicit Numbers(std::vector<double>& values) : values_(&values) {}
  void take(const RosScalar& scalar) override { values_->push_back(scalar.number()); }

 private:
  std::vector<double>* values_;
};

class Texts : public FieldSink {
 public:
  void take(const RosScalar& scalar) override { texts.emplace_back(scalar.text); }
  std::vector<std::string> texts;
};

bool has_layout(const RosType& type) {
  const std::vector<RosField>& fields = type.root().fields;
  return !fields.empty() && fields.front().structure &&
         type.structures[*fields.front().structure].name == "std_msgs/MultiArrayLayout";
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
  if (!names.empty()) {
    SOMATO_TRY(reader.names_, FieldReader::compile(type, names, FieldKind::kTexts));
  }
  if (has_layout(*type) && paths == std::vector<std::string>{"data"}) {
    SOMATO_TRY(reader.lengths_, FieldReader::compile(type, "layout.dim[*].size"));
    SOMATO_TRY(reader.offset_, FieldReader::compile(type, "layout.data_offset"));
  }
  return reader;
}

Result<void> ChannelReader::read(std::string_view message, std::vector<double>& values) const {
  values.clear();
  Numbers sink(values);
  for (const FieldReader& reader : values_) SOMATO_TRY_VOID(reader.read(message, sink));
  if (!offset_) return {};
  SOMATO_TRY(const std::vector<double> offset, numbers_at(*offset_, message));
  const auto skipped = std::min(static_cast<std::size_t>(offset.front()), values.size());
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(skipped));
  return {};
}

Result<std::vector<std::string>> ChannelReader::element_names(std::string_view message) const {
  if (lengths_) return std::vector<std::string>();
  std::vector<std::string> places;
  for (const FieldReader& reader : values_) {
    SOMATO_TRY(std::vector<std::string> more, reader.names(message));
    places.insert(places.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
  }
  if (!names_) return places;
  Texts sink;
  SOMATO_TRY_VOID(names_->read(message, sink));
  return sink.texts.size() == places.size() ? std::move(sink.texts) : std::vector<std::string>();
}

Result<std::vector<std::size_t>> ChannelReader::shape(std::string_view message) const {
  std::vector<std::size_t> shape;
  if (!lengths_) return shape;
  SOMATO_TRY(const std::vector<double> lengths, numbers_at(*lengths_, message));
  std::vector<double> values;
  SOMATO_TRY_VOID(read(message, values));
  std::size_t elements = 1;
  for (const double length : lengths) {
    shape.push_back(static_cast<std::size_t>(length));
    elements = shape.back() == 0 || elements > values.size() ? 0 : elements * shape.back();
  }
  if (elements != values.size() || shape.size() < 2) shape.clear();
  return shape;
}

}  // namespace somato
