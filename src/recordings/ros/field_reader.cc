#include "recordings/ros/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <utility>

#include "base/text/text.h"
#include "recordings/ros/cdr.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

constexpr std::string_view kAdviceOnPaths =
    "write field names with dots between, and elements in brackets: sensors[*].taxels[0..3].z";

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

bool take_index(std::string_view& text, std::size_t& index) {
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), index);
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return status == std::errc{};
}

// The part of a path up to the next dot outside brackets, which is cut off with the dot. A dot at
// the end stays, as the start of a part without a name.
std::string_view take_part(std::string_view& rest) {
  std::size_t end = 0;
  bool is_inside = false;
  for (; end < rest.size() && (is_inside || rest[end] != '.'); ++end) {
    is_inside = rest[end] == '[' || (is_inside && rest[end] != ']');
  }
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(end + 1 < rest.size() ? end + 1 : end);
  return part;
}

// "*", "2" or "2..5".
bool parse_elements(std::string_view text, std::size_t& first, std::size_t& last) {
  if (text == "*") return true;
  if (!take_index(text, first)) return false;
  last = first;
  if (text.empty()) return true;
  if (!text.starts_with("..")) return false;
  text.remove_prefix(2);
  return take_index(text, last) && text.empty() && first <= last;
}

template <typename Signed>
double signed_number(std::uint64_t bits) {
  return static_cast<double>(static_cast<Signed>(bits));
}

class IgnoredValues : public FieldSink {
 public:
  void take(const RosScalar&) override {}
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

// One reading of a message along the steps of a path.
class FieldReader::Walk {
 public:
  Walk(const FieldReader& reader, std::string_view message, FieldSink& sink,
       std::vector<std::string>* names)
      : type_(reader.type_.get()),
        steps_(&reader.steps_),
        kind_(reader.kind_),
        message_(message),
        from_(message),
        sink_(&sink),
        names_(names) {}

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
    if (step.last != kUnbounded && step.last >= count) {
      return fail_at(field, fmt::format("has {} elements, fewer than the path demands", count));
    }
    const std::size_t length = trail_.size();
    for (std::size_t i = 0; i < count && !failure_; ++i) {
      if (i < step.first || i > step.last) {
        pass_element(field);
        continue;
      }
      enter(field, i, length);
      if (depth + 1 < steps_->size()) {
        follow(*field.structure, depth + 1);
      } else {
        take_element(field);
      }
      trail_.resize(length);
    }
  }

  void take(const RosField& field) {
    const std::size_t count = elements_of(field);
    const std::size_t length = trail_.size();
    for (std::size_t i = 0; i < count && !failure_; ++i) {
      enter(field, i, length);
      take_element(field);
      trail_.resize(length);
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
    sink_->take(scalar);
    if (names_) names_->push_back(trail_);
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

  void enter(const RosField& field, std::size_t element, std::size_t length) {
    if (!names_) return;
    trail_ += (length > 0 ? "." : "") + field.name;
    if (field.kind != RosField::Kind::kOne) trail_ += fmt::format("[{}]", element);
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
  std::vector<std::string>* names_;
  std::string trail_;
  std::optional<Error> failure_;
};

Result<FieldReader::Step> FieldReader::parse_step(const RosStructure& structure,
                                                  std::string_view& rest) const {
  const std::string_view part = take_part(rest);
  const std::size_t bracket = std::min(part.find('['), part.size());
  const std::string_view name = part.substr(0, bracket);
  const auto found = std::find_if(structure.fields.begin(), structure.fields.end(),
                                  [&](const RosField& field) { return field.name == name; });
  if (found == structure.fields.end()) {
    return fail(unknown_name("field", std::string(name), path_, names_of(structure)));
  }
  Step step{static_cast<std::size_t>(found - structure.fields.begin())};
  if (bracket == part.size()) return step;
  const std::string_view elements = part.substr(bracket + 1);
  if (!elements.ends_with(']') ||
      !parse_elements(elements.substr(0, elements.size() - 1), step.first, step.last)) {
    return fail(ErrorKind::kUsage, fmt::format("{} selects no elements", shown(part)), path_,
                std::string(kAdviceOnPaths));
  }
  const bool is_beyond = step.last != kUnbounded && step.last >= found->length;
  if (found->kind != RosField::Kind::kOne && !is_beyond) return step;
  return fail(ErrorKind::kUsage,
              is_beyond && found->kind != RosField::Kind::kOne
                  ? fmt::format("{} has at most {} elements, from 0", shown(name), found->length)
                  : fmt::format("{} is a single value, without elements", shown(name)),
              path_);
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
      return reader;
    }
    if (!field.structure) {
      return fail(ErrorKind::kUsage, fmt::format("{} has no fields", shown(field.name)),
                  reader.path_);
    }
    structure = &reader.type_->structures[*field.structure];
  }
}

Result<void> FieldReader::read(std::string_view message, FieldSink& sink) const {
  SOMATO_TRY_VOID(check_cdr_encapsulation(message));
  return Walk(*this, message, sink, nullptr).run();
}

Result<std::vector<std::string>> FieldReader::names(std::string_view message) const {
  SOMATO_TRY_VOID(check_cdr_encapsulation(message));
  std::vector<std::string> names;
  IgnoredValues sink;
  SOMATO_TRY_VOID(Walk(*this, message, sink, &names).run());
  return names;
}

std::vector<std::string> field_paths(const RosType& type, FieldKind kind, std::size_t most) {
  std::vector<std::string> paths;
  add_field_paths(type, type.structures.size() - 1, {}, kind, most, paths);
  return paths;
}

}  // namespace somato
