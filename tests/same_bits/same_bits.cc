// Prints a line for each case: its name and a checksum of the bits it gives. The test
// house.same_bits compares the lines of two compilers.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "base/archives/archive.h"
#include "base/core/elementary.h"
#include "base/files/toml_file.h"
#include "base/kernels/instruction_set.h"
#include "maps/som/som_archive.h"
#include "somato/codes/spectrum.h"
#include "somato/core/random.h"
#include "somato/core/signal.h"
#include "somato/core/value.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som_training.h"
#include "somato/maps/t_mpsom.h"
#include "somato/recording/recording.h"

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

// Lengths of one factor and of several, even and odd.
void print_spectra() {
  Random random(13);
  Checksum checksum;
  for (const std::size_t length : std::vector<std::size_t>{7, 64, 210, 225, 1024}) {
    SpectrumParameters parameters;
    parameters.transform_length = length;
    parameters.bands = 0;
    parameters.scale = SpectrumScale::kLogarithmic;
    Matrix<float> frames(length, 20);
    for (float& value : frames.values()) value = static_cast<float>(random.normal());
    const Signal spectra = Spectrum(parameters).apply(frames, 0.0).value();
    for (const float value : spectra.values()) checksum.add(double{value});
  }
  checksum.print("codes.spectrum");
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
  print_case("elementary.cosine_of_turns",
             [](Random& random) { return cosine_of_turns(10.0 * random.uniform() - 5.0); });
  print_case("signal.inner_product", product_of_noise);
  print_case("value.to_toml", [](Random& random) { return to_toml({wide(random)}); });
  print_spectra();
}

Samples noise(std::size_t count, std::size_t size) {
  Random random(11);
  Matrix<float> rows(count, size);
  for (float& value : rows.values()) value = static_cast<float>(random.normal());
  return Samples(std::move(rows));
}

// A map of each kind of training, as its model file holds it.
std::string saved_map(const SomParameters& parameters, const Samples& samples,
                      std::size_t threads) {
  Archive archive("som");
  add_som(archive, "", train_som(parameters, samples, {threads, {}}).value());
  return encode_archive(archive);
}

std::vector<SomParameters> kinds_of_training() {
  std::vector<SomParameters> kinds;
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const auto& [similarity, name] : Choices<Similarity>::all()) {
      SomParameters p;
      p.rows = 10;
      p.columns = 15;
      p.lattice = lattice;
      p.similarity = similarity;
      p.topology = Topology::kTorus;
      p.arithmetic = Arithmetic::kPlain;
      p.radius_schedule = ScheduleShape::kExponential;
      kinds.push_back(p);
      p.arithmetic = Arithmetic::kInnerProducts;
      if (follows_from_products(similarity)) kinds.push_back(p);
      p.arithmetic = Arithmetic::kAutomatic;
      p.training = Training::kBatch;
      kinds.push_back(p);
    }
  }
  SomParameters bubble;
  bubble.rows = bubble.columns = 15;
  bubble.lattice = Lattice::kHexagonal;
  bubble.neighbourhood = NeighbourhoodShape::kBubble;
  bubble.initial_weights = InitialWeights::kSamples;
  bubble.draws = Draws::kWithoutReplacement;
  bubble.arithmetic = Arithmetic::kPlain;
  kinds.push_back(bubble);
  bubble.initial_weights = InitialWeights::kUniform;
  bubble.training = Training::kBatch;
  kinds.push_back(bubble);
  // With the arithmetic of eigenvectors, and checks of the error.
  SomParameters linear = bubble;
  linear.initial_weights = InitialWeights::kLinear;
  linear.tolerance = 1e-3;
  linear.most_checks = 5;
  for (const auto& [shape, name] : Choices<NeighbourhoodShape>::all()) {
    linear.neighbourhood = shape;
    linear.training =
        shape == NeighbourhoodShape::kMexicanHat ? Training::kOnline : Training::kBatch;
    linear.similarity =
        shape == NeighbourhoodShape::kMexicanHat ? Similarity::kDotProduct : Similarity::kEuclidean;
    if (shape != NeighbourhoodShape::kBubble) kinds.push_back(linear);
  }
  return kinds;
}

std::string name_of(const SomParameters& p) {
  return "som." + choice_name(p.lattice) + "." + choice_name(p.topology) + "." +
         choice_name(p.neighbourhood) + "." + choice_name(p.similarity) + "." +
         choice_name(p.training) + "." + choice_name(p.arithmetic);
}

std::string saved_t_mpsom() {
  TMpsomParameters parameters;
  parameters.shape = {9, 14};
  parameters.input_sizes = {20, 30};
  parameters.iterations = 300;
  TMpsom map(parameters);
  Random random(12);
  std::vector<std::array<std::vector<float>, 2>> frames(50);
  for (auto& frame : frames) {
    for (std::size_t input = 0; input < 2; ++input) {
      frame[input].resize(parameters.input_sizes[input]);
      for (float& value : frame[input]) value = static_cast<float>(random.uniform());
    }
  }
  TMpsom::Workspace workspace(map);
  for (std::uint64_t t = 0; t < parameters.iterations; ++t) {
    const auto& frame = frames[t % frames.size()];
    const SignalView inputs[] = {SignalView::dense(frame[0]), SignalView::dense(frame[1])};
    map.learn(inputs, parameters.learning_rate().at(t), workspace);
  }
  std::string bytes;
  for (std::size_t input = 0; input < 2; ++input) {
    const Matrix<float> weights = map.weights(input);
    const auto* first = reinterpret_cast<const char*>(weights.values().data());
    bytes.append(first, weights.values().size_bytes());
  }
  return bytes;
}

// Ranges, a T-MPSOM beside a tensor product, a standardization, a map: all that learns.
const char* const kSystem = R"(
[module.fingers]
type = "channel"
channel = "joints"
elements = ["1", "2"]

[module.wrist]
type = "channel"
channel = "joints"
elements = ["3"]

[module.fingers_code]
type = "one_hot"
input = "fingers"
elements = 6

[module.wrist_code]
type = "one_hot"
input = "wrist"
elements = 5

[module.product]
type = "tensor_product"
inputs = ["fingers_code", "wrist_code"]

[module.memory]
type = "accumulate"
input = "product"

[module.binding]
type = "t_mpsom"
inputs = ["fingers_code", "wrist_code"]
shape = [6, 7]
iterations = 200

[module.bound]
type = "accumulate"
input = "binding"

[module.both]
type = "concatenation"
inputs = ["memory", "bound"]

[module.scaled]
type = "standardization"
input = "both"
constant_columns = "zero"

[module.map]
type = "som"
input = "scaled"
rows = 6
columns = 6
iterations = 300
)";

Recording noise_in_the_hand() {
  Random random(17);
  Recording recording;
  for (std::size_t i = 0; i < 12; ++i) {
    Matrix<float> frames(5 + i % 3, 3);
    for (float& value : frames.values()) value = static_cast<float>(random.normal());
    recording.explorations.push_back({{}, {}, {{"joints", "deg", {}, std::move(frames), {}}}});
  }
  return recording;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A trained system as its file holds it.
std::string saved_system(const Recording& recording, std::size_t threads) {
  const auto description = read_system(parse_toml(kSystem, "system").value()).value();
  System system = System::build(description, layout_of(recording)).value();
  std::vector<std::size_t> all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations = evaluate_fixed(system, recording, {}, threads).value();
  if (!train_system(system, recording, all, {9, threads, {}}, activations)) return {};
  const auto path = std::filesystem::path("same_bits.somato");
  if (!save_system(path.string(), system)) return {};
  std::string bytes = bytes_of(path);
  std::filesystem::remove(path);
  return bytes;
}

// Prints the checksum of what `make(threads)` gives on the portable instruction set with one
// thread; false when another set or number of threads gives other bytes. Each set runs with one
// number of threads; over the cases, which have consecutive numbers, it meets all of them.
template <typename Make>
bool print_everywhere_the_same(std::size_t number, const std::string& name, const Make& make) {
  use_instruction_set(InstructionSet::kPortable);
  const std::string expected = make(1);
  if (expected.empty()) {
    std::printf("%s gives nothing\n", name.c_str());
    return false;
  }
  Checksum checksum;
  checksum.add(expected);
  checksum.print(name.c_str());
  for (const InstructionSet set : available_instruction_sets()) {
    use_instruction_set(set);
    constexpr std::size_t kThreads[] = {1, 2, 4};
    const std::size_t threads = kThreads[number++ % 3];
    if (make(threads) == expected) continue;
    std::printf("%s differs with %s, %zu threads\n", name.c_str(), name_of(set).c_str(), threads);
    return false;
  }
  return true;
}

bool print_trained_maps() {
  const Samples samples = noise(30, 70);
  bool same = true;
  std::size_t number = 0;
  // Not a line of the output: processors differ in what they have.
  for (const InstructionSet set : available_instruction_sets()) {
    std::fprintf(stderr, "compared: %s\n", name_of(set).c_str());
  }
  for (const SomParameters& parameters : kinds_of_training()) {
    same &= print_everywhere_the_same(number++, name_of(parameters), [&](std::size_t threads) {
      return saved_map(parameters, samples, threads);
    });
  }
  same &= print_everywhere_the_same(number++, "t_mpsom",
                                    [](std::size_t /*threads*/) { return saved_t_mpsom(); });
  const Recording recording = noise_in_the_hand();
  same &= print_everywhere_the_same(
      number, "system", [&](std::size_t threads) { return saved_system(recording, threads); });
  return same;
}

}  // namespace
}  // namespace somato

int main() {
  somato::print_all();
  return somato::print_trained_maps() ? 0 : 1;
}
