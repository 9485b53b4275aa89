// Prints a line for each case: its name and a checksum of the bits it gives. The test
// house.same_bits compares the lines of two compilers.

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "somato/core/elementary.h"
#include "somato/core/random.h"
#include "somato/core/signal.h"
#include "somato/core/value.h"

namespace somato {
namespace {

// FNV-1a, 64 bits, over bytes in a fixed order.
class Checksum {
 public:
  void add_byte(std::uint8_t byte) { sum_ = (sum_ ^ byte) * 0x100000001B3ULL; }

  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<std::uint8_t>(word >> shift));
  }

  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

  void add(const std::string& text) {
    for (const char character : text) add_byte(static_cast<std::uint8_t>(character));
  }

  void print(const char* name) const {
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(sum_));
  }

 private:
  std::uint64_t sum_ = 0xCBF29CE484222325ULL;
};

constexpr int kCount = 100000;

// The checksum of kCount values that `draw` gives, one after the other.
template <typename Draw>
void print_case(const char* name, const Draw& draw) {
  Random random(7);
  Checksum checksum;
  for (int i = 0; i < kCount; ++i) checksum.add(draw(random));
  checksum.print(name);
}

// Each draw stands in a statement of its own: the order of arguments is the compiler's choice.

double wide(Random& random) {
  const double mantissa = 0.5 + random.uniform();
  return std::ldexp(mantissa, static_cast<int>(random.below(1000)) - 500);
}

double power_of_noise(Random& random) {
  const double base = random.uniform();
  return power(base, 10.0 * random.uniform());
}

double product_of_noise(Random& random) {
  std::vector<float> left(random.below(64));
  std::vector<float> right(left.size());
  for (float& value : left) value = static_cast<float>(random.normal());
  for (float& value : right) value = static_cast<float>(random.normal());
  return inner_product(SignalView::dense(left), SignalView::dense(right));
}

float initial_weight(Random& random) {
  const std::uint32_t row = random.next();
  return uniform_at(3, Stream::kInitialWeights, row, random.next());
}

void print_all() {
  print_case("random.next", [](Random& random) { return std::uint64_t{random.next()}; });
  print_case("random.uniform", [](Random& random) { return random.uniform(); });
  print_case("random.below", [](Random& random) { return random.below(1000003); });
  print_case("random.normal", [](Random& random) { return random.normal(); });
  print_case("random.uniform_at", [](Random& random) { return double{initial_weight(random)}; });
  print_case("elementary.exponential",
             [](Random& random) { return exponential(1400.0 * random.uniform() - 700.0); });
  print_case("elementary.natural_log", [](Random& random) { return natural_log(wide(random)); });
  print_case("elementary.power", power_of_noise);
  print_case("signal.inner_product", product_of_noise);
  print_case("value.to_toml", [](Random& random) { return to_toml({wide(random)}); });
}

}  // namespace
}  // namespace somato

int main() {
  somato::print_all();
}
