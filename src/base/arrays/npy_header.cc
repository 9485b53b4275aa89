#include "base/arrays/npy_header.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "base/archives/little_endian.h"
#include "base/text/text.h"

namespace somato {
namespace {

// Parses the subset of Python that numpy writes. Every function returns whether it succeeded.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view text) : rest_(text) {}

  bool parse(NpyHeader& header) {
    if (!take('{')) return false;
    while (!take('}')) {
      if (!entry(header)) return false;
      if (!take(',') && !at('}')) return false;
    }
    skip_blanks();
    return rest_.empty() && has_type_ && has_order_ && has_shape_;
  }

 private:
  void skip_blanks() {
    const std::size_t next = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(next == std::string_view::npos ? rest_.size() : next);
  }

  bool at(char c) {
    skip_blanks();
    return rest_.starts_with(c);
  }

  bool take(char c) {
    if (!at(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool take_word(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  std::optional<std::string> text() {
    skip_blanks();
    if (rest_.empty() || (rest_[0] != '\'' && rest_[0] != '"')) return {};
    const std::size_t end = rest_.find(rest_[0], 1);
    if (end == std::string_view::npos) return {};
    std::string found(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return found;
  }

  // Each key once.
  bool entry(NpyHeader& header) {
    const std::optional<std::string> key = text();
    if (!key || !take(':')) return false;
    if (*key == "descr" && !has_type_) return has_type_ = type(header.type);
    if (*key == "fortran_order" && !has_order_) return has_order_ = order(header.fortran_order);
    if (*key == "shape" && !has_shape_) return has_shape_ = shape(header.shape);
    return false;
  }

  bool type(std::string& out) {
    if (at('[')) return skip_list(out);
    std::optional<std::string> found = text();
    if (found) out = std::move(*found);
    return found.has_value();
  }

  // The fields of a structured array, of which only the end matters.
  bool skip_list(std::string& out) {
    out = "structured";
    int depth = 0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      depth += rest_[i] == '[' ? 1 : rest_[i] == ']' ? -1 : 0;
      if (depth > 0) continue;
      rest_.remove_prefix(i + 1);
      return true;
    }
    return false;
  }

  bool order(bool& fortran) {
    fortran = take_word("True");
    return fortran || take_word("False");
  }

  bool shape(std::vector<std::uint64_t>& sizes) {
    if (!take('(')) return false;
    while (!take(')')) {
      if (!size(sizes)) return false;
      const bool should_continue = take(',');
      const bool ends = at(')') && sizes.size() > 1;
      if (!should_continue && !ends) return false;
    }
    return true;
  }

  // numpy under Python 2 wrote long integers with an L.
  bool size(std::vector<std::uint64_t>& sizes) {
    skip_blanks();
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc()) return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if (rest_.starts_with('L')) rest_.remove_prefix(1);
    sizes.push_back(number);
    return true;
  }

  std::string_view rest_;
  bool has_type_ = false;
  bool has_order_ = false;
  bool has_shape_ = false;
};

}  // namespace

Result<NpyHeader> parse_npy_header(std::string_view text, std::string_view where) {
  NpyHeader header;
  if (!HeaderParser(text).parse(header)) {
    return fail(ErrorKind::kData,
                fmt::format("the header {} is not in the format of numpy", shown(text)),
                std::string(where), "save the array again with numpy.save");
  }
  return header;
}

std::string npy_file_start(std::string_view type, std::span<const std::size_t> shape,
                           bool fortran_order) {
  constexpr std::size_t kAlignment = 64;
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({}{}), }}",
                                   type, fortran_order ? "True" : "False", fmt::join(shape, ", "),
                                   shape.size() == 1 ? "," : "");
  const std::size_t before = kNpyMagic.size() + 4;
  while ((before + header.size() + 1) % kAlignment != 0) header += ' ';
  header += '\n';
  std::string bytes(kNpyMagic);
  bytes += '\1';
  bytes += '\0';
  append_little_endian(bytes, static_cast<std::uint16_t>(header.size()));
  return bytes + header;
}

}  // namespace somato
