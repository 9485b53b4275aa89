#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "somato/studies/results.h"

namespace somato::detail {

/// A curve needs at least this number of points in one of its lines.
inline constexpr std::size_t kFewestPoints = 3;

/// The number in TOML notation, if `text` is a finite one.
std::optional<double> number_in(const std::string& text);

/// A point of a CurveReport of web/schema/report.json.
nlohmann::ordered_json point_json(double x, const Metric& metric);

}  // namespace somato::detail
