#include "systems/modules/support.h"

#include <algorithm>
#include <optional>

namespace somato::modules {
namespace {

class WinnerModule : public MappedModule {
 public:
  using Parameters = NoParameters;
  explicit WinnerModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    PortType type = inputs.front().type;
    type.sparse = true;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& /*scratch*/) const override {
    out.begin_sparse(inputs.front().size);
    out.add(place_of_greatest(inputs.front()), 1.0F);
    return {};
  }

 private:
  // The first in a tie. Zeros that are not stored are not visited individually: there may be
  // thousands of millions.
  static std::uint32_t place_of_greatest(const SignalView& input) {
    const auto most = std::max_element(input.values.begin(), input.values.end());
    const auto stored = static_cast<std::size_t>(most - input.values.begin());
    if (!input.sparse) return static_cast<std::uint32_t>(stored);
    if (most != input.values.end() && *most > 0.0F) return input.indices[stored];
    return first_zero(input).value_or(stored < input.indices.size() ? input.indices[stored] : 0);
  }

  // The first zero of a sparse signal, stored or not.
  static std::optional<std::uint32_t> first_zero(const SignalView& input) {
    std::uint32_t place = 0;
    while (place < input.indices.size() && input.indices[place] == place &&
           input.values[place] != 0.0F) {
      ++place;
    }
    if (place == input.size) return {};
    return place;
  }
};

}  // namespace

std::vector<ModuleType> winner_types() {
  return {describe<WinnerModule>("winner", "Position of the greatest element.",
                                 {input_port("A signal such as a map's activity.")},
                                 "The input's shape, 1 at that position and 0 elsewhere; sparse.")};
}

}  // namespace somato::modules
