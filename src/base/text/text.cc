#include "base/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/text/utf8.h"

namespace somato {
namespace {

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7F;
}

}  // namespace

std::size_t first_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = first_character(text.substr(i)).bytes;
    if (length == 0) return i;
    i += length;
  }
  return std::string_view::npos;
}

bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= kLongestName && is_utf8(text) &&
         std::none_of(text.begin(), text.end(), is_control);
}

std::size_t first_byte_of_no_text(std::string_view bytes) {
  return std::min(bytes.find('\0'), first_invalid_utf8(bytes));
}

tl::unexpected<Error> no_text(std::string_view bytes, std::size_t bad, std::size_t lines_before,
                              std::string_view where) {
  const auto ends = std::count(bytes.begin(), bytes.begin() + static_cast<long>(bad), '\n');
  return fail(ErrorKind::kData, fmt::format("byte 0x{:02X} is not UTF-8 text", byte_at(bytes, bad)),
              fmt::format("{}:{}", where, 1 + lines_before + static_cast<std::size_t>(ends)),
              "save the file as UTF-8 text, or check that it is the right file");
}

Result<std::string_view> text_of(std::string_view bytes, std::string_view where) {
  const std::size_t bad = first_byte_of_no_text(bytes);
  if (bad != std::string_view::npos) return no_text(bytes, bad, 0, where);
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  return bytes;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.emplace_back(text);
  return parts;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 40;
  const bool cut = text.size() > kMost;
  std::size_t length = std::min(text.size(), kMost);
  // Not in the middle of a character.
  while (cut && length > 0 && (byte_at(text, length) & 0xC0) == 0x80) --length;
  std::string out(text.substr(0, length));
  std::replace_if(out.begin(), out.end(), is_control, '?');
  return fmt::format("'{}{}'", out, cut ? "..." : "");
}

std::string shown_list(const std::vector<std::string>& texts) {
  constexpr std::size_t kMost = 8;
  const std::size_t count = std::min(texts.size(), kMost);
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += (i == 0 ? "" : ", ") + shown(texts[i]);
  return count < texts.size() ? out + fmt::format(" and {} others", texts.size() - count) : out;
}

}  // namespace somato
