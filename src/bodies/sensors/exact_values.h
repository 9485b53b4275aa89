#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "somato/recording/recording.h"

namespace somato::detail {

/// The floats whose sum is a number in double precision: recordings hold floats, and a reading is
/// the same to the last bit only if the true value is.
constexpr std::size_t kParts = 3;

/// The number as the sum of floats, the greatest first: the first is the number itself, rounded.
std::array<float, kParts> parts_of(double value);

/// The number of which these are the parts.
double whole_of(float first, float second, float third);

/// The names of true channels begin with it: these are values of the simulation, not readings.
constexpr std::string_view kTruePrefix = "true_";

bool is_true_channel(const Channel& channel);

/// A channel of exact values: a frame has the first parts of all values, then their second and
/// third parts, under the names of the values with "_rest" and "_rest_2" at the end.
Channel exact_channel(std::string name, std::string unit, const std::vector<std::string>& names);

/// Adds a frame of exact values to such a channel.
void add_exact(Channel& channel, std::span<const double> values);

/// The values of a frame of such a channel.
std::vector<double> exact_row(const Channel& channel, std::size_t frame);

/// The channel of that name, or nullptr.
const Channel* true_channel(const Exploration& exploration, std::string_view name);

/// Whether a number in a true channel is a whole one from 0 to `most`: more would be drawn for
/// hours.
bool is_count(double value, double most);

/// An error about a true channel that another program wrote or changed.
tl::unexpected<Error> bad_truth(const Channel& channel, const std::string& what);

/// Whether a true channel has frames of as many elements, all of them valid. Errors: kData.
Result<void> check_truth(const Channel& channel, std::size_t elements);

}  // namespace somato::detail
