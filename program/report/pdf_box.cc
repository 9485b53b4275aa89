#include "report/pdf_box.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

namespace somato::program {
namespace {

constexpr double kPoint = 72.0 / 25.4;  // points in a mm

constexpr std::string_view kBox = "/MediaBox [0 0 ";
// For programs that read pages aloud; a picture needs no order of its links.
constexpr std::string_view kUnneeded = "/StructParents 0\n/Tabs /S";

// The height in a box "/MediaBox [0 0 WIDTH HEIGHT]" that begins at `at`.
double height_at(const std::string& pdf, std::size_t at) {
  const std::size_t blank = pdf.find(' ', at + kBox.size());
  return blank == std::string::npos ? 0.0 : std::strtod(pdf.c_str() + blank, nullptr);
}

}  // namespace

std::string cut_page(std::string pdf, double width, double height) {
  const std::size_t at = pdf.find(kBox);
  const std::size_t spare = pdf.find(kUnneeded, at);
  const std::size_t end = pdf.find(']', at);
  if (at == std::string::npos || spare == std::string::npos || end > spare) return pdf;
  const double top = height_at(pdf, at);
  std::string part =
      fmt::format("/MediaBox [0 {:.3f} {:.3f} {:.3f}]", top - height * kPoint, width * kPoint, top);
  part += pdf.substr(end + 1, spare - end - 1);
  // The file ends in a table of the places of its parts, which must not move.
  const std::size_t length = spare + kUnneeded.size() - at;
  if (part.size() > length) return pdf;
  part.resize(length, ' ');
  return pdf.replace(at, length, part);
}

}  // namespace somato::program
