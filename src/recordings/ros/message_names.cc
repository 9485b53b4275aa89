#include "recordings/ros/message_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "base/archives/little_endian.h"
#include "recordings/ros/known_types.h"

namespace somato {
namespace {

constexpr std::array<std::string_view, 3> kFieldsOfNames = {"name", "names", "joint_names"};

bool has_elements(const RosField& field) {
  return field.kind != RosField::Kind::kOne;
}

// The numbers of the elements on the way to a place.
std::vector<std::size_t> elements_of(FieldPlace place) {
  std::vector<std::size_t> elements;
  for (const FieldStep& step : place) {
    if (has_elements(*step.field)) elements.push_back(step.element);
  }
  return elements;
}

using Place = std::vector<FieldStep>;

class PlacesOfValues : public FieldSink {
 public:
  void take(const RosScalar&, FieldPlace place) override {
    places.emplace_back(place.begin(), place.end());
  }
  std::vector<Place> places;
};

// The texts of a path by their elements.
class PlacedTexts : public FieldSink {
 public:
  void take(const RosScalar& scalar, FieldPlace place) override {
    std::vector<std::size_t> elements = elements_of(place);
    depth = elements.size();
    in_order.emplace_back(scalar.text);
    by_elements.emplace(std::move(elements), scalar.text);
  }
  std::vector<std::string> in_order;
  std::map<std::vector<std::size_t>, std::string> by_elements;
  std::size_t depth = 0;
};

class TextKey : public FieldSink {
 public:
  explicit TextKey(std::string& key) : key_(&key) {}
  void take(const RosScalar& scalar, FieldPlace place) override {
    append_little_endian(*key_, static_cast<std::uint64_t>(scalar.text.size()));
    *key_ += scalar.text;
    add_to_key(place, *key_);
  }

 private:
  std::string* key_;
};

// The part of a place that is not named by the first `named` elements, on a path of that depth: the
// further elements, and fields below the path.
std::string rest_of(FieldPlace place, std::size_t named, std::size_t depth) {
  std::string rest;
  std::size_t elements = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (i >= depth) rest += "." + place[i].field->name;
    if (!has_elements(*place[i].field)) continue;
    if (++elements > named) rest += fmt::format("[{}]", place[i].element);
  }
  return rest;
}

// The names of the values at one path, and the elements of the texts that they use.
class NamesOfPath {
 public:
  NamesOfPath(const std::vector<PlacedTexts>& texts, std::size_t depth)
      : texts_(&texts), used_(texts.size()), depth_(depth) {}

  // Empty if a text is missing.
  std::string name_of(FieldPlace place) {
    const std::vector<std::size_t> elements = elements_of(place);
    std::string name;
    std::size_t named = 0;
    for (std::size_t i = 0; i < texts_->size(); ++i) {
      const PlacedTexts& texts = (*texts_)[i];
      if (elements.size() < texts.depth) return {};
      const auto end = elements.begin() + static_cast<std::ptrdiff_t>(texts.depth);
      const auto found = texts.by_elements.find({elements.begin(), end});
      if (found == texts.by_elements.end()) return {};
      used_[i].insert(found->first);
      named = std::max(named, texts.depth);
      name += (name.empty() ? "" : "/") + found->second;
    }
    return name + rest_of(place, named, depth_);
  }

  bool has_used_all() const {
    for (std::size_t i = 0; i < texts_->size(); ++i) {
      if (used_[i].size() != (*texts_)[i].by_elements.size()) return false;
    }
    return true;
  }

 private:
  const std::vector<PlacedTexts>* texts_;
  std::vector<std::set<std::vector<std::size_t>>> used_;
  std::size_t depth_;
};

std::string without_brackets(std::string_view path) {
  std::string plain;
  std::size_t depth = 0;
  for (const char c : path) {
    if (c == '[') ++depth;
    if (depth == 0) plain += c;
    if (c == ']' && depth > 0) --depth;
  }
  return plain;
}

// The path of texts that are names by convention in the structure that `before` leads to.
std::string conventional_names(const RosStructure& structure, const std::string& before) {
  for (const RosField& field : structure.fields) {
    const bool is_named =
        std::find(kFieldsOfNames.begin(), kFieldsOfNames.end(), field.name) != kFieldsOfNames.end();
    const bool is_text = !field.structure && field.primitive == RosPrimitive::kString;
    const bool is_of_element = before.ends_with("[*].");
    if (is_named && is_text && (has_elements(field) || is_of_element)) return before + field.name;
  }
  return {};
}

std::string names_of_known_type(const RosType& type, std::string_view path) {
  const KnownType* known = known_type(type.root().name);
  if (!known) return {};
  for (const KnownChannel& channel : known->channels) {
    if (without_brackets(channel.path) == path) return std::string(channel.names);
  }
  return {};
}

}  // namespace

void add_to_key(FieldPlace place, std::string& key) {
  for (const FieldStep& step : place) {
    append_little_endian(key, reinterpret_cast<std::uintptr_t>(step.field));
    append_little_endian(key, static_cast<std::uint64_t>(step.element));
  }
}

Result<MessageNames> MessageNames::compile(const std::shared_ptr<const RosType>& type,
                                           const std::string& names) {
  MessageNames compiled;
  for (const std::string& path : split_outside_brackets(names, '+')) {
    SOMATO_TRY(FieldReader reader, FieldReader::compile(type, path, FieldKind::kTexts));
    compiled.texts_.push_back(std::move(reader));
  }
  return compiled;
}

Result<std::vector<std::string>> MessageNames::of(const std::vector<FieldReader>& paths,
                                                  std::string_view message) const {
  std::vector<PlacedTexts> texts(texts_.size());
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    SOMATO_TRY_VOID(texts_[i].read(message, texts[i]));
  }
  std::vector<std::string> names;
  bool is_named = true;
  for (const FieldReader& path : paths) {
    PlacesOfValues values;
    SOMATO_TRY_VOID(path.read(message, values));
    NamesOfPath of_path(texts, path.depth());
    for (const Place& place : values.places) {
      std::string name = of_path.name_of(place);
      const bool is_padding = name.empty() && path.is_padded();
      is_named = is_named && (!name.empty() || is_padding);
      if (is_padding) {
        name = to_string(place);
      } else if (paths.size() > 1) {
        name = element_of_path(path, name);
      }
      names.push_back(std::move(name));
    }
    is_named = is_named && (!path.has_all_elements() || of_path.has_used_all());
  }
  // One list of texts for the values of all paths.
  const bool is_list = texts.size() == 1 && texts.front().in_order.size() == names.size();
  if (is_list) return std::move(texts.front().in_order);
  if (!is_named) names.clear();
  return names;
}

Result<void> MessageNames::add_to_key(std::string_view message, std::string& key) const {
  TextKey sink(key);
  for (const FieldReader& texts : texts_) SOMATO_TRY_VOID(texts.read(message, sink));
  return {};
}

std::string element_of_path(const FieldReader& path, std::string_view name) {
  return fmt::format("{}[{}]", without_brackets(path.path()), name);
}

std::string usual_names(const RosType& type, const FieldReader& path) {
  const std::string plain = without_brackets(path.path());
  std::string names = names_of_known_type(type, plain);
  if (!names.empty()) return names;
  const RosStructure* structure = &type.root();
  std::string before;
  for (std::string_view rest = plain;;) {
    const std::string_view part = take_path_part(rest);
    std::string closer = conventional_names(*structure, before);
    if (!closer.empty()) names = std::move(closer);
    const auto field = std::find_if(structure->fields.begin(), structure->fields.end(),
                                    [&](const RosField& each) { return each.name == part; });
    if (rest.empty()) return names;
    structure = &type.structures[*field->structure];
    before += field->name + (has_elements(*field) ? "[*]." : ".");
  }
}

}  // namespace somato
