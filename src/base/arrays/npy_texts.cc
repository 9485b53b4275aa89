#include "base/arrays/npy_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"
#include "base/arrays/npy_layout.h"
#include "base/core/memory.h"
#include "base/text/text.h"
#include "base/text/utf8.h"

namespace somato {
namespace {

constexpr std::size_t kCharacter = sizeof(std::uint32_t);
constexpr std::string_view kUnicode = "<U";

// The code points of a text in UTF-8.
std::vector<std::uint32_t> code_points(std::string_view text) {
  std::vector<std::uint32_t> points;
  points.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0U) == 0x80U;
    if (continues && !points.empty()) {
      points.back() = points.back() << 6U | (byte & 0x3FU);
    } else {
      const std::uint32_t lead = byte < 0x80   ? 0x7FU
                                 : byte < 0xE0 ? 0x1FU
                                 : byte < 0xF0 ? 0x0FU
                                               : 7U;
      points.push_back(byte & lead);
    }
  }
  return points;
}

tl::unexpected<Error> refuse(std::string_view where, std::string what) {
  return fail(ErrorKind::kData, std::move(what), std::string(where),
              "save the array again with numpy.save");
}

// The number of characters of each text of an array of that type.
std::optional<std::size_t> characters_of(std::string_view type) {
  if (!type.starts_with(kUnicode)) return {};
  std::size_t characters = 0;
  const char* const last = type.data() + type.size();
  const auto [end, error] = std::from_chars(type.data() + kUnicode.size(), last, characters);
  if (error != std::errc() || end != last) return {};
  return characters;
}

bool is_character(std::uint32_t point) {
  constexpr std::uint32_t kLast = 0x10FFFF;
  return point <= kLast && (point < 0xD800 || point > 0xDFFF);
}

// Without the zeros that pad it.
std::optional<std::string> text_at(const char* bytes, std::size_t characters) {
  const auto point_at = [&](std::size_t i) {
    return little_endian<std::uint32_t>(bytes + i * kCharacter);
  };
  while (characters > 0 && point_at(characters - 1) == 0) --characters;
  std::string text;
  for (std::size_t i = 0; i < characters; ++i) {
    if (!is_character(point_at(i))) return {};
    append_character(text, static_cast<char32_t>(point_at(i)));
  }
  return text;
}

}  // namespace

std::string npy_of_texts(const std::vector<std::string>& texts,
                         std::span<const std::size_t> shape) {
  std::vector<std::vector<std::uint32_t>> points;
  points.reserve(texts.size());
  std::size_t longest = 1;  // numpy has no texts of no length.
  for (const std::string& text : texts) {
    points.push_back(code_points(text));
    longest = std::max(longest, points.back().size());
  }
  std::string bytes = npy_file_start(fmt::format("{}{}", kUnicode, longest), shape);
  for (std::vector<std::uint32_t>& text : points) {
    text.resize(longest, 0);
    for (const std::uint32_t point : text) append_little_endian(bytes, point);
  }
  return bytes;
}

std::string npy_of_texts(const std::vector<std::string>& texts) {
  return npy_of_texts(texts, std::array{texts.size()});
}

Result<std::vector<std::string>> texts_in_npy(std::string_view bytes, std::string_view where) {
  SOMATO_TRY(const NpyStart start, npy_start_of(bytes, bytes.size(), where));
  const std::optional<std::size_t> characters = characters_of(start.header.type);
  if (!characters || start.header.shape.size() > 1) {
    return refuse(where,
                  fmt::format("an array of type {} with {} dimensions is not a list of texts",
                              shown(start.header.type), start.header.shape.size()));
  }
  const std::uint64_t count = start.header.shape.empty() ? 1 : start.header.shape[0];
  const std::size_t available = bytes.size() - start.size;
  const bool is_possible = *characters >= 1 && *characters <= available / kCharacter;
  const std::size_t size = *characters * kCharacter;
  if (!is_possible || available % size != 0 || available / size != count) {
    return refuse(where, fmt::format("the array has {} bytes, which are not {} texts of {} "
                                     "characters",
                                     available, count, *characters));
  }
  SOMATO_TRY_VOID(check_free_memory(count, sizeof(std::string), where));
  std::vector<std::string> texts;
  texts.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto text = text_at(bytes.data() + start.size + i * size, *characters);
    if (!text)
      return refuse(where, fmt::format("text {} contains numbers that are no characters", i + 1));
    texts.push_back(std::move(*text));
  }
  return texts;
}

}  // namespace somato
