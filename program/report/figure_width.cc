#include "report/figure_width.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace somato::program {
namespace {

constexpr double kLeast = 20.0;  // mm; text is not legible below
constexpr double kMost = 500.0;  // mm; a poster of the size A2 is 420 mm wide

constexpr std::array<std::pair<std::string_view, double>, 3> kUnits{
    {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}}};

tl::unexpected<Error> refuse(const std::string& what) {
  return fail(ErrorKind::kUsage, what, "--width", "give it as 85mm, 8.5cm or 3.3in");
}

}  // namespace

Result<double> figure_width(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  for (const auto& [name, millimetres] : kUnits) {
    if (error != std::errc() || unit != name) continue;
    const double width = number * millimetres;
    if (width >= kLeast && width <= kMost) return width;
    return refuse(fmt::format("'{}' is not from {} to {} mm", text, kLeast, kMost));
  }
  return refuse(fmt::format("'{}' is not a width with a unit", text));
}

}  // namespace somato::program
