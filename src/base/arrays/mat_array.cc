#include "base/arrays/mat_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/archives/inflate.h"
#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"
#include "base/arrays/npy_layout.h"
#include "base/arrays/sparse_rows.h"
#include "base/text/flag_hint.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

constexpr std::size_t kVersionPlace = 124;
constexpr std::size_t kTag = 8;
constexpr std::size_t kSmallTag = 4;  // An element with at most 4 bytes is in the same 8 bytes.
constexpr std::uint32_t kMatrixElement = 14;
constexpr std::uint32_t kCompressedElement = 15;
constexpr unsigned kSparseClass = 5;
constexpr unsigned kFirstNumberClass = 6;  // double
constexpr unsigned kLastNumberClass = 15;  // uint64
constexpr unsigned kComplexFlag = 0x08;

// A type of stored numbers, by its number in the file, and numpy's name of it.
struct StoredType {
  std::uint32_t id;
  std::string_view kind;
  std::size_t size;
};

constexpr StoredType kStoredTypes[] = {{1, "i", 1},  {2, "u", 1}, {3, "i", 2}, {4, "u", 2},
                                       {5, "i", 4},  {6, "u", 4}, {7, "f", 4}, {9, "f", 8},
                                       {12, "i", 8}, {13, "u", 8}};

const StoredType* stored_type(std::uint32_t id) {
  for (const StoredType& type : kStoredTypes) {
    if (type.id == id) return &type;
  }
  return nullptr;
}

// A data element: its type and content.
struct Element {
  std::uint32_t type = 0;
  std::string_view content;
};

// Takes the elements of a list apart, in the file's byte order.
class Elements {
 public:
  Elements(std::string_view bytes, bool is_big) : rest_(bytes), is_big_(is_big) {}

  bool at_end() const { return rest_.empty(); }

  std::optional<Element> next() {
    if (rest_.size() < kTag) return std::nullopt;
    const std::uint32_t first = number(rest_.data());
    constexpr unsigned kHalf = 16;
    if (first >> kHalf != 0) {  // A small element has both in one number.
      const std::size_t size = first >> kHalf;
      if (size > kTag - kSmallTag) return std::nullopt;
      return take(first & 0xFFFFU, kSmallTag, size, kTag);
    }
    const std::size_t size = number(rest_.data() + kSmallTag);
    // Compressed elements are not padded.
    const std::size_t padded = first == kCompressedElement ? size : (size + kTag - 1) / kTag * kTag;
    if (rest_.size() - kTag < size) return std::nullopt;
    return take(first, kTag, size, std::min(kTag + padded, rest_.size()));
  }

  std::uint32_t number(const char* bytes) const {
    return is_big_ ? big_endian<std::uint32_t>(bytes) : little_endian<std::uint32_t>(bytes);
  }

 private:
  Element take(std::uint32_t type, std::size_t start, std::size_t size, std::size_t whole) {
    const Element element{type, rest_.substr(start, size)};
    rest_.remove_prefix(whole);
    return element;
  }

  std::string_view rest_;
  bool is_big_;
};

// The parts that every variable has.
struct Variable {
  std::string name;
  unsigned kind = 0;
  bool is_complex = false;
  std::vector<std::size_t> shape;
};

class MatFile {
 public:
  MatFile(std::string_view bytes, std::string where)
      : bytes_(bytes), where_(std::move(where)), is_big_(bytes.substr(126, 2) == "MI") {}

  Result<std::string> npy_of(const std::string& wanted) const {
    std::vector<std::string> names;
    std::optional<std::string> found;
    Elements elements(bytes_.substr(kMatHeader), is_big_);
    while (!elements.at_end()) {
      const std::optional<Element> element = elements.next();
      if (!element) return bad("the file is cut within a variable");
      SOMATO_TRY(const std::string inflated, matrix_in(*element));
      const std::string_view content =
          element->type == kCompressedElement ? std::string_view(inflated) : element->content;
      if (content.empty()) continue;
      Elements parts(content, is_big_);
      SOMATO_TRY(const Variable variable, head_of(parts));
      const bool is_named = variable.name == wanted;
      if (!is_named && !is_matrix(variable)) continue;
      names.push_back(variable.name);
      if (!is_named && (!wanted.empty() || names.size() > 1)) continue;
      SOMATO_TRY(found, numbers_of(variable, parts));
      if (is_named) return *found;
    }
    return chosen(wanted, names, std::move(found));
  }

 private:
  tl::unexpected<Error> bad(std::string what, std::string advice = "save it again") const {
    return fail(ErrorKind::kData, std::move(what), where_, std::move(advice));
  }

  static bool is_matrix(const Variable& variable) {
    return (variable.kind == kSparseClass ||
            (variable.kind >= kFirstNumberClass && variable.kind <= kLastNumberClass)) &&
           variable.shape.size() == 2 && !variable.is_complex;
  }

  Result<std::string> chosen(const std::string& wanted, const std::vector<std::string>& names,
                             std::optional<std::string> found) const {
    if (!wanted.empty()) return fail(unknown_name("variable", wanted, where_, names));
    if (found && names.size() == 1) return std::move(*found);
    if (names.empty()) {
      return bad("the file contains no matrix of real numbers",
                 "save a matrix with one row per sample");
    }
    return fail(ErrorKind::kUsage,
                fmt::format("the file contains several matrices: {}", fmt::join(names, ", ")),
                where_, "select one of these variables" + flag_hint("variable"));
  }

  // The inflated content of a compressed variable; nothing for other elements.
  Result<std::string> matrix_in(const Element& element) const {
    if (element.type != kCompressedElement) return std::string();
    Result<std::string> tag = inflate_bytes(element.content, kTag, Deflated::kZlib);
    if (!tag) return bad(tag.error().what);
    if (tag->size() < kTag) return bad("a compressed variable is cut");
    const Elements numbers({}, is_big_);
    if (numbers.number(tag->data()) != kMatrixElement) return std::string();
    const std::size_t size = numbers.number(tag->data() + kSmallTag);
    Result<std::string> all = inflate_bytes(element.content, kTag + size, Deflated::kZlib);
    if (!all) {
      all.error().where = where_;
      return all;
    }
    if (all->size() != kTag + size) return bad("a compressed variable is cut");
    return all->substr(kTag);
  }

  Result<Variable> head_of(Elements& parts) const {
    const auto flags = parts.next();
    const auto shape = parts.next();
    const auto name = parts.next();
    if (!flags || !shape || !name || flags->content.size() < kTag ||
        shape->content.size() % sizeof(std::int32_t) != 0) {
      return bad("the description of a variable is damaged");
    }
    const std::uint32_t bits = parts.number(flags->content.data());
    Variable variable{
        std::string(name->content), bits & 0xFFU, ((bits >> 8U) & kComplexFlag) != 0, {}};
    for (std::size_t i = 0; i < shape->content.size(); i += sizeof(std::int32_t)) {
      variable.shape.push_back(parts.number(shape->content.data() + i));
    }
    return variable;
  }

  Result<std::string> numbers_of(const Variable& variable, Elements& parts) const {
    if (!is_matrix(variable)) {
      return bad(fmt::format("the variable '{}' is no matrix of real numbers", variable.name),
                 "save a matrix with one row per sample");
    }
    return variable.kind == kSparseClass ? sparse_of(variable, parts) : full_of(variable, parts);
  }

  Result<Element> numbers_in(const std::optional<Element>& part, const Variable& variable) const {
    if (part && stored_type(part->type) != nullptr) return *part;
    return bad(fmt::format("the variable '{}' has no numbers", variable.name));
  }

  // The same array in an NPY file: its numbers are in Fortran order as well.
  Result<std::string> full_of(const Variable& variable, Elements& parts) const {
    SOMATO_TRY(const Element numbers, numbers_in(parts.next(), variable));
    const StoredType& type = *stored_type(numbers.type);
    const char order = type.size == 1 ? '|' : is_big_ ? '>' : '<';
    std::string bytes =
        npy_file_start(fmt::format("{}{}{}", order, type.kind, type.size), variable.shape, true);
    bytes += numbers.content;
    return bytes;
  }

  Result<std::string> sparse_of(const Variable& variable, Elements& parts) const {
    SOMATO_TRY(const Element rows, numbers_in(parts.next(), variable));
    SOMATO_TRY(const Element starts, numbers_in(parts.next(), variable));
    SOMATO_TRY(const Element stored, numbers_in(parts.next(), variable));
    SparseMatrix matrix{variable.shape[0], variable.shape[1], {}, {}, doubles_in(stored)};
    const std::vector<double> places = doubles_in(starts);
    // The lists may be longer than the matrix has elements.
    const double last = places.empty() ? 0.0 : places.back();
    std::vector<double> indices = doubles_in(rows);
    if (!(last >= 0.0) || last > static_cast<double>(indices.size()) ||
        last > static_cast<double>(matrix.values.size())) {
      return bad(fmt::format("the lists of the sparse matrix '{}' do not fit", variable.name));
    }
    const auto elements = static_cast<std::size_t>(last);
    indices.resize(elements);
    matrix.values.resize(elements);
    SOMATO_TRY(matrix.row, indices_below(indices, matrix.rows, where_));
    SOMATO_TRY(matrix.column, lines_of_starts(places, matrix.columns, elements, where_));
    return npy_of_sparse(matrix, where_);
  }

  std::vector<double> doubles_in(const Element& element) const {
    const StoredType& type = *stored_type(element.type);
    const NpyType& reads = *npy_type(fmt::format("{}{}{}",
                                                 type.size == 1 ? '|'
                                                 : is_big_      ? '>'
                                                                : '<',
                                                 type.kind, type.size));
    std::vector<double> numbers(element.content.size() / type.size);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = reads.read(element.content.data() + i * type.size);
    }
    return numbers;
  }

  std::string_view bytes_;
  std::string where_;
  bool is_big_;
};

}  // namespace

bool is_mat(std::string_view bytes) {
  if (bytes.size() < kMatHeader || !bytes.starts_with("MATLAB ")) return false;
  const std::string_view order = bytes.substr(126, 2);
  return order == "IM" || order == "MI";
}

Result<std::string> npy_in_mat(std::string_view bytes, const std::string& where,
                               const std::string& variable) {
  constexpr unsigned kLevel5 = 1;
  const bool is_big = bytes.substr(126, 2) == "MI";
  const char version = bytes[kVersionPlace + (is_big ? 0 : 1)];
  if (static_cast<unsigned char>(version) != kLevel5) {
    return fail(ErrorKind::kData, "it is a MAT-file of version 7.3 (HDF5)", where,
                "save it with save(..., '-v7') or scipy.io.savemat");
  }
  return MatFile(bytes, where).npy_of(variable);
}

}  // namespace somato
