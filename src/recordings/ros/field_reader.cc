#include "recordings/ros/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "base/text/text.h"
#include "recordings/ros/cdr.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

constexpr std::string_view kAdviceOnPaths =
    "write field names with dots between, and elements in brackets: sensors[*].taxels[0..3].z, "
    "sensors[*:32].z or, by their names, position[shoulder,elbow]";

constexpr std::size_t kMostPadded = std::size_t{1} << 16;  // Above the elements of any skin.

// The number of an element that a message lacks.
constexpr RosScalar kMissingNumber{
    RosPrimitive::kFloat64,
    std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN()),
    {}};

bool is_of_kind(RosPrimitive type, FieldKind kind) {
  return is_text(type) == (kind == FieldKind::kTexts);
}

// Whether the structure contains primitive fields of that kind.
bool contains_kind(const RosType& type, std::size_t structure, FieldKind kind) {
  std::vector<bool> contains(structure + 1, false);
  for (std::size_t i = 0; i <= structure; ++i) {
    for (const RosField& field : type.structures[i].fields) {
      contains[i] = contains[i] || (field.structure ? contains[*field.structure]
                                                    : is_of_kind(field.primitive, kind));
    }
  }
  return contains[structure];
}

std::vector<std::string> names_of(const RosStructure& structure) {
  std::vector<std::string> names;
  names.reserve(structure.fields.size());
  for (const RosField& field : structure.fields) names.push_back(field.name);
  return names;
}

// Whether an element of the field contains sequences, directly or in its structures.
bool contains_sequences(const RosType& type, const RosField& field) {
  if (!field.structure) return false;
  std::vector<bool> contains(*field.structure + 1, false);
  for (std::size_t i = 0; i <= *field.structure; ++i) {
    for (const RosField& inner : type.structures[i].fields) {
      const bool is_sequence = inner.kind == RosField::Kind::kSequence;
      contains[i] = contains[i] || is_sequence || (inner.structure && contains[*inner.structure]);
    }
  }
  return contains[*field.structure];
}

template <typename Signed>
double signed_number(std::uint64_t bits) {
  return static_cast<double>(static_cast<Signed>(bits));
}

class PlacesInWords : public FieldSink {
 public:
  void take(const RosScalar&, FieldPlace place) override { places.push_back(to_string(place)); }
  std::vector<std::string> places;
};

void add_field_paths(const RosType& type, std::size_t structure, const std::string& before,
                     FieldKind kind, std::size_t most, std::vector<std::string>& paths) {
  for (const RosField& field : type.structures[structure].fields) {
    if (paths.size() >= most) return;
    const std::string path =
        before + field.name + (field.kind == RosField::Kind::kOne ? "" : "[*]");
    if (!field.structure) {
      if (is_of_kind(field.primitive, kind)) paths.push_back(path);
    } else if (contains_kind(type, *field.structure, kind)) {
      add_field_paths(type, *field.structure, path + ".", kind, most, paths);
    }
  }
}

}  // namespace

double RosScalar::number() const {
  switch (type) {
    case RosPrimitive::kBool:
      return bits == 0 ? 0.0 : 1.0;
    case RosPrimitive::kInt8:
      return signed_number<std::int8_t>(bits);
    case RosPrimitive::kInt16:
      return signed_number<std::int16_t>(bits);
    case RosPrimitive::kInt32:
      return signed_number<std::int32_t>(bits);
    case RosPrimitive::kInt64:
      return signed_number<std::int64_t>(bits);
    case RosPrimitive::kUint8:
    case RosPrimitive::kUint16:
    case RosPrimitive::kUint32:
    case RosPrimitive::kUint64:
      return static_cast<double>(bits);
    case RosPrimitive::kFloat32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case RosPrimitive::kFloat64:
      return std::bit_cast<double>(bits);
    case RosPrimitive::kString:
    case RosPrimitive::kWstring:
      break;
  }
  return 0.0;
}

std::string to_string(const RosScalar& scalar) {
  if (is_text(scalar.type)) return std::string(scalar.text);
  if (scalar.type == RosPrimitive::kUint64) return fmt::format("{}", scalar.bits);
  if (scalar.type == RosPrimitive::kInt64) {
    return fmt::format("{}", static_cast<std::int64_t>(scalar.bits));
  }
  if (scalar.type == RosPrimitive::kFloat32) {
    return fmt::format("{}", static_cast<float>(scalar.number()));
  }
  return fmt::format("{}", scalar.number());
}

std::string to_string(FieldPlace place) {
  std::string text;
  for (const FieldStep& step : place) {
    text += (text.empty() ? "" : ".") + step.field->name;
    if (step.field->kind != RosField::Kind::kOne) text += fmt::format("[{}]", step.element);
  }
  return text;
}

// One reading of a message along the steps of a path.
class FieldReader::Walk {
 public:
  Walk(const FieldReader& reader, std::string_view message, FieldSink& sink)
      : type_(reader.type_.get()),
        steps_(&reader.steps_),
        kind_(reader.kind_),
        message_(message),
        from_(message),
        sink_(&sink) {}

  Result<void> run() {
    follow(type_->structures.size() - 1, 0);
    if (!failure_) return {};
    return fail(std::move(*failure_));
  }

 private:
  // The values at the remaining steps of a structure. What follows the last value of the path is
  // only passed over within elements.
  void follow(std::size_t structure, std::size_t depth) {
    const std::vector<RosField>& fields = type_->structures[structure].fields;
    const Step& step = (*steps_)[depth];
    for (std::size_t i = 0; i < step.field && !failure_; ++i) pass(fields[i]);
    if (!failure_) select(fields[step.field], step, depth);
    if (depth == 0) return;
    for (std::size_t i = step.field + 1; i < fields.size() && !failure_; ++i) pass(fields[i]);
  }

  void select(const RosField& field, const Step& step, std::size_t depth) {
    const std::size_t count = elements_of(field);
    if (failure_) return;
    if (step.elements.last != kUnbounded && step.elements.last >= count &&
        !step.elements.is_padded) {
      return fail_at(field, fmt::format("has {} elements, fewer than the path demands", count));
    }
    for (std::size_t i = 0; i < count && !failure_; ++i) {
      if (i < step.elements.first || i > step.elements.last) {
        pass_element(field);
        continue;
      }
      place_.push_back({&field, i});
      if (depth + 1 < steps_->size()) {
        follow(*field.structure, depth + 1);
      } else {
        take_element(field);
      }
      place_.pop_back();
    }
    if (step.elements.is_padded && !failure_) pad(field, count, step.elements.last, depth);
  }

  // The missing numbers of the elements from `first` to `last`.
  void pad(const RosField& field, std::size_t first, std::size_t last, std::size_t depth) {
    for (std::size_t i = first; i <= last; ++i) {
      place_.push_back({&field, i});
      if (!field.structure) {
        sink_->take(kMissingNumber, place_);
      } else if (depth + 1 < steps_->size()) {
        const Step& next = (*steps_)[depth + 1];
        const RosField& inner = type_->structures[*field.structure].fields[next.field];
        const std::size_t end = inner.kind == RosField::Kind::kOne ? 1 : inner.length;
        pad(inner, next.elements.first, std::min(end - 1, next.elements.last), depth + 1);
      } else {
        pad_structure(*field.structure, depth);
      }
      place_.pop_back();
    }
  }

  void pad_structure(std::size_t structure, std::size_t depth) {
    for (const RosField& inner : type_->structures[structure].fields) {
      if (!inner.structure && !is_of_kind(inner.primitive, kind_)) continue;
      pad(inner, 0, (inner.kind == RosField::Kind::kOne ? 1 : inner.length) - 1, depth);
    }
  }

  void take(const RosField& field) {
    const std::size_t count = elements_of(field);
    for (std::size_t i = 0; i < count && !failure_; ++i) {
      place_.push_back({&field, i});
      take_element(field);
      place_.pop_back();
    }
  }

  void take_element(const RosField& field) {
    if (field.structure) return take_structure(*field.structure);
    if (!is_of_kind(field.primitive, kind_)) return pass_element(field);
    if (field.primitive == RosPrimitive::kWstring) return pass_wide_text(field);
    RosScalar scalar{field.primitive, 0, {}};
    if (field.primitive == RosPrimitive::kString) {
      scalar.text = from_.text();
    } else {
      scalar.bits = from_.bits(size_of(field.primitive));
    }
    if (!from_.fits()) return fail_at(field, "does not fit into the message");
    sink_->take(scalar, place_);
  }

  void take_structure(std::size_t structure) {
    const std::vector<RosField>& fields = type_->structures[structure].fields;
    if (fields.empty()) from_.skip(1, 1);
    for (const RosField& field : fields) {
      if (!failure_) take(field);
    }
  }

  void pass(const RosField& field) {
    const std::size_t count = elements_of(field);
    if (failure_) return;
    if (!field.structure && !is_text(field.primitive)) {
      from_.skip(size_of(field.primitive), count);
      if (!from_.fits()) fail_at(field, "does not fit into the message");
      return;
    }
    for (std::size_t i = 0; i < count && !failure_; ++i) pass_element(field);
  }

  void pass_element(const RosField& field) {
    if (field.structure) {
      const std::vector<RosField>& fields = type_->structures[*field.structure].fields;
      if (fields.empty()) from_.skip(1, 1);
      for (std::size_t i = 0; i < fields.size() && !failure_; ++i) pass(fields[i]);
    } else if (field.primitive == RosPrimitive::kWstring) {
      pass_wide_text(field);
    } else if (field.primitive == RosPrimitive::kString) {
      (void)from_.text();
    } else {
      from_.skip(size_of(field.primitive), 1);
    }
    if (!from_.fits()) fail_at(field, "does not fit into the message");
  }

  // Characters have two bytes in some middlewares and four in others.
  void pass_wide_text(const RosField& field) {
    if (from_.bits(sizeof(std::uint32_t)) == 0 || failure_) return;
    fail_at(field, "is a wstring, whose encoding depends on the middleware");
  }

  std::size_t elements_of(const RosField& field) {
    if (field.kind != RosField::Kind::kSequence) return field.length;
    const std::size_t count = from_.count(least_bytes_of_element(*type_, field));
    if (!from_.fits()) {
      fail_at(field, "does not fit into the message");
    } else if (count > field.length) {
      fail_at(field, fmt::format("has {} elements, more than {}", count, field.length));
    }
    return failure_ ? 0 : count;
  }

  void fail_at(const RosField& field, const std::string& what) {
    if (failure_) return;
    failure_ = Error{ErrorKind::kData,
                     fmt::format("the field {} {} (at byte {} of {})", shown(field.name), what,
                                 std::min(from_.place(), message_.size()), message_.size()),
                     {},
                     {}};
  }

  const RosType* type_;
  const std::vector<Step>* steps_;
  FieldKind kind_;
  std::string_view message_;
  CdrReader from_;
  FieldSink* sink_;
  std::vector<FieldStep> place_;
  std::optional<Error> failure_;
};

Result<FieldReader::Step> FieldReader::parse_step(const RosStructure& structure,
                                                  std::string_view& rest) {
  const std::string_view part = take_path_part(rest);
  const std::size_t bracket = std::min(part.find('['), part.size());
  const std::string_view name = part.substr(0, bracket);
  const auto found = std::find_if(structure.fields.begin(), structure.fields.end(),
                                  [&](const RosField& field) { return field.name == name; });
  if (found == structure.fields.end()) {
    return fail(unknown_name("field", std::string(name), path_, names_of(structure)));
  }
  Step step{static_cast<std::size_t>(found - structure.fields.begin()), {}};
  if (bracket == part.size()) return step;
  SOMATO_TRY_VOID(parse_brackets(part, bracket, rest.empty(), step));
  const bool is_beyond = step.elements.last != kUnbounded && step.elements.last >= found->length;
  if (found->kind != RosField::Kind::kOne && !is_beyond) return step;
  return fail(ErrorKind::kUsage,
              is_beyond && found->kind != RosField::Kind::kOne
                  ? fmt::format("{} has at most {} elements, from 0", shown(name), found->length)
                  : fmt::format("{} is a single value, without elements", shown(name)),
              path_);
}

// `part` is "sensors[0..3]", with the bracket there.
Result<void> FieldReader::parse_brackets(std::string_view part, std::size_t bracket, bool is_last,
                                         Step& step) {
  const auto wrong = [&](std::string what) {
    return fail(ErrorKind::kUsage, std::move(what), path_, std::string(kAdviceOnPaths));
  };
  std::optional<PathElements> elements;
  if (part.ends_with(']')) {
    elements = parse_path_elements(part.substr(bracket + 1, part.size() - bracket - 2));
  }
  const bool is_for_numbers = elements && (elements->is_padded || !elements->names.empty());
  if (!elements || (is_for_numbers && kind_ == FieldKind::kTexts)) {
    return wrong(fmt::format("{} selects no elements", shown(part)));
  }
  if (!elements->names.empty() && !is_last) {
    return wrong("names select elements only in the last brackets of a path");
  }
  step.elements = std::move(*elements);
  if (is_last) last_bracket_ = path_.size() - part.size() + bracket;
  return {};
}

Result<void> FieldReader::check_target(const RosField& target) const {
  const bool has_values = target.structure ? contains_kind(*type_, *target.structure, kind_)
                                           : is_of_kind(target.primitive, kind_);
  if (has_values) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("the field {} holds no {}", shown(target.name),
                          kind_ == FieldKind::kTexts ? "texts" : "numbers"),
              path_);
}

Result<FieldReader> FieldReader::compile(std::shared_ptr<const RosType> type, std::string_view path,
                                         FieldKind kind) {
  FieldReader reader(std::move(type), std::string(path), kind);
  const RosStructure* structure = &reader.type_->root();
  std::string_view rest = reader.path_;
  for (;;) {
    SOMATO_TRY(const Step step, reader.parse_step(*structure, rest));
    reader.steps_.push_back(step);
    const RosField& field = structure->fields[step.field];
    if (rest.empty()) {
      SOMATO_TRY_VOID(reader.check_target(field));
      SOMATO_TRY_VOID(reader.check_padding());
      return reader;
    }
    if (!field.structure) {
      return fail(ErrorKind::kUsage, fmt::format("{} has no fields", shown(field.name)),
                  reader.path_);
    }
    structure = &reader.type_->structures[*field.structure];
  }
}

const RosField& FieldReader::field_at(std::size_t depth) const {
  const RosStructure* structure = &type_->root();
  for (std::size_t i = 0; i < depth; ++i) {
    structure = &type_->structures[*structure->fields[steps_[i].field].structure];
  }
  return structure->fields[steps_[depth].field];
}

bool FieldReader::has_fixed_length(std::size_t depth) const {
  return field_at(depth).kind != RosField::Kind::kSequence ||
         steps_[depth].elements.last != kUnbounded;
}

// The content of an element that a message lacks must be known from the type, and be of a size
// that a channel can have.
Result<void> FieldReader::check_padding() const {
  std::size_t padded = 0;
  while (padded < depth() && !steps_[padded].elements.is_padded) ++padded;
  if (padded == depth()) return {};
  bool is_fixed = !contains_sequences(*type_, field_at(depth() - 1));
  std::size_t elements = 1;
  for (std::size_t i = padded; i < depth(); ++i) {
    is_fixed = is_fixed && has_fixed_length(i);
    const PathElements& selected = steps_[i].elements;
    const std::size_t last = std::min(selected.last, field_at(i).length - 1);
    elements = last < kMostPadded ? elements * (last - selected.first + 1) : kMostPadded + 1;
    if (elements > kMostPadded) break;
  }
  if (is_fixed && elements <= kMostPadded) return {};
  return fail(ErrorKind::kUsage,
              is_fixed ? fmt::format("the path selects more than {} elements", kMostPadded)
                       : "elements that a message lacks have no fixed number of values",
              path_, "give each sequence a number of elements, such as [*:4]");
}

bool FieldReader::has_all_elements() const {
  return std::all_of(steps_.begin(), steps_.end(), [](const Step& step) {
    return step.elements.first == 0 && step.elements.last == kUnbounded;
  });
}

bool FieldReader::is_padded() const {
  return std::any_of(steps_.begin(), steps_.end(),
                     [](const Step& step) { return step.elements.is_padded; });
}

bool FieldReader::has_varying_places() const {
  std::size_t sequences = 0;
  for (std::size_t i = 0; i < depth(); ++i) sequences += has_fixed_length(i) ? 0U : 1U;
  return sequences > 1 || contains_sequences(*type_, field_at(depth() - 1));
}

Result<void> FieldReader::read(std::string_view message, FieldSink& sink) const {
  SOMATO_TRY_VOID(check_cdr_encapsulation(message));
  return Walk(*this, message, sink).run();
}

Result<std::vector<std::string>> FieldReader::names(std::string_view message) const {
  PlacesInWords sink;
  SOMATO_TRY_VOID(read(message, sink));
  return std::move(sink.places);
}

std::vector<std::string> field_paths(const RosType& type, FieldKind kind, std::size_t most) {
  std::vector<std::string> paths;
  add_field_paths(type, type.structures.size() - 1, {}, kind, most, paths);
  return paths;
}

}  // namespace somato
