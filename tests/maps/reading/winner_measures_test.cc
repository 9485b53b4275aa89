#include "maps/reading/winner_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

constexpr std::size_t kA = 0;
constexpr std::size_t kB = 1;
constexpr std::size_t kC = 2;

// Neurons and samples:
//
//   0  1  2  3      a  .  b  b
//   4  5  6  7      .  .  .  c
//   8  9 10 11      ab .  .  c
const Grid kPlane(3, 4, Lattice::kRectangular, Topology::kPlane);
const Grid kTorus(3, 4, Lattice::kRectangular, Topology::kTorus);
const Numbers kWinners{0, 2, 3, 7, 11, 8, 8};
const Numbers kClasses{kA, kB, kB, kC, kC, kA, kB};

TEST(ClassesSeparated, AreClassesThatShareNoNeuron) {
  EXPECT_EQ(separated_classes(kWinners, kClasses), (std::vector<bool>{false, false, true}));
  EXPECT_EQ(separated_classes({4, 4, 5}, {kA, kA, kB}), (std::vector<bool>{true, true}));
}

TEST(ClassesSeparated, IsNoClassWithoutSamples) {
  EXPECT_EQ(separated_classes({4, 5}, {kC, kA}), (std::vector<bool>{true, false, true}));
}

TEST(Undetermined, AreSamplesThatShareANeuronWithAnotherClass) {
  EXPECT_EQ(ambiguous_samples(kWinners, kClasses), 2U);
  EXPECT_EQ(ambiguous_samples({4, 4, 5}, {kA, kA, kB}), 0U);
}

// P11's bimodal system: three explorations of a and four of b with one centre of activation.
TEST(Undetermined, CountsAllThatShare) {
  EXPECT_EQ(ambiguous_samples({9, 9, 9, 9, 9, 9, 9, 3, 2}, {0, 0, 0, 1, 1, 1, 1, 0, 1}), 7U);
}

// The a above is 2 away from the b beside it and from both samples below it. The b in the corner
// is as near to the other b as to the c below it, and the upper c to either: theirs is their own.
TEST(Surroundings, AreOfTheNearestOthers) {
  EXPECT_EQ(classes_of_surroundings(kPlane, kWinners, kClasses),
            (Numbers{kB, kB, kB, kC, kC, kB, kA}));
}

// Around the torus the b in the corner touches a, b and two c; the lower c touches a, two b and c.
TEST(Surroundings, GoOnAtTheEdgesOfATorus) {
  EXPECT_EQ(classes_of_surroundings(kTorus, kWinners, kClasses),
            (Numbers{kB, kB, kC, kC, kB, kB, kA}));
}

// Neuron 4, in the middle, touches 3 in its own row and 8 in the next:
//
//   0  1  2
//     3  4  5
//   6  7  8
TEST(Surroundings, AreEquallyFarOnAHexagonalGridDespiteRounding) {
  const Grid grid(3, 3, Lattice::kHexagonal, Topology::kPlane);
  EXPECT_EQ(classes_of_surroundings(grid, {4, 3, 8, 8}, {5, 0, 1, 1})[0], 1U);
  EXPECT_EQ(classes_of_surroundings(grid, {4, 3, 3, 8}, {5, 1, 1, 0})[0], 1U);
  EXPECT_EQ(classes_of_surroundings(grid, {4, 3, 8}, {5, 1, 0})[0], 0U);
  EXPECT_EQ(classes_of_surroundings(grid, {4, 3, 8}, {1, 1, 0})[0], 1U);
}

// On the torus neuron 0 touches 9 and 11; on the plane 9 is nearer.
//
//   0  1  2
//     3  4  5
//   6  7  8
//     9 10 11
TEST(Surroundings, GoOnAtTheEdgesOfAHexagonalTorus) {
  const Grid plane(4, 3, Lattice::kHexagonal, Topology::kPlane);
  const Grid torus(4, 3, Lattice::kHexagonal, Topology::kTorus);
  EXPECT_EQ(classes_of_surroundings(plane, {0, 9, 11, 11}, {kC, kA, kB, kB})[0], kA);
  EXPECT_EQ(classes_of_surroundings(torus, {0, 9, 11, 11}, {kC, kA, kB, kB})[0], kB);
}

TEST(Surroundings, OfASingleSampleAreItsOwn) {
  EXPECT_EQ(classes_of_surroundings(kPlane, {6}, {kC}), Numbers{kC});
}

TEST(Border, IsTheOuterRowsAndColumns) {
  EXPECT_DOUBLE_EQ(share_on_border(kPlane, {0, 5, 6, 11}), 0.5);
  EXPECT_DOUBLE_EQ(share_on_border(kTorus, {5, 6, 7, 6}), 0.25);
  EXPECT_DOUBLE_EQ(share_on_border(kPlane, {4, 7, 1, 9}), 1.0);
}

TEST(Border, OfASmallMapIsAllOfIt) {
  EXPECT_DOUBLE_EQ(border_of(kPlane), 10.0 / 12.0);
  EXPECT_DOUBLE_EQ(border_of(Grid(15, 15, Lattice::kRectangular, Topology::kPlane)), 56.0 / 225.0);
  EXPECT_DOUBLE_EQ(border_of(Grid(2, 2, Lattice::kRectangular, Topology::kPlane)), 1.0);
  EXPECT_DOUBLE_EQ(border_of(Grid(1, 9, Lattice::kRectangular, Topology::kPlane)), 1.0);
}

TEST(WinnerMeasures, RefuseWhatDoesNotFit) {
  EXPECT_THROW((void)separated_classes({1, 2}, {0}), InvalidArgument);
  EXPECT_THROW((void)separated_classes({}, {}), InvalidArgument);
  EXPECT_THROW((void)ambiguous_samples({1}, {0, 1}), InvalidArgument);
  EXPECT_THROW((void)ambiguous_samples({}, {}), InvalidArgument);
  EXPECT_THROW((void)classes_of_surroundings(kPlane, {1, 2}, {0}), InvalidArgument);
  EXPECT_THROW((void)classes_of_surroundings(kPlane, {}, {}), InvalidArgument);
  EXPECT_THROW((void)classes_of_surroundings(kPlane, {12}, {0}), InvalidArgument);
  EXPECT_THROW((void)share_on_border(kPlane, {12}), InvalidArgument);
  EXPECT_THROW((void)share_on_border(kPlane, {}), InvalidArgument);
  EXPECT_THROW((void)border_of(Grid()), InvalidArgument);
}

// The slow ways below.

struct MeasuredWinners {
  Grid grid;
  Numbers winners;
  Numbers classes;
};

MeasuredWinners random_winners(Random& random) {
  const auto lattice = random.below(2) == 0 ? Lattice::kRectangular : Lattice::kHexagonal;
  const auto topology = random.below(2) == 0 ? Topology::kPlane : Topology::kTorus;
  const std::size_t rows = 2 * (1 + random.below(3));
  const std::size_t columns = 1 + random.below(6);
  MeasuredWinners problem{Grid(rows, columns, lattice, topology), {}, {}};
  const std::size_t samples = 1 + random.below(20);
  const std::size_t classes = 1 + random.below(5);
  for (std::size_t i = 0; i < samples; ++i) {
    problem.winners.push_back(random.below(problem.grid.size()));
    problem.classes.push_back(random.below(classes));
  }
  return problem;
}

// Four times the squared distance is a whole number: of half columns, and of rows of 1 or of
// sqrt(3)/2. On a torus the nearest of nine copies of the map counts.
long exact_distance(const Grid& grid, std::size_t a, std::size_t b) {
  const bool hexagonal = grid.lattice() == Lattice::kHexagonal;
  const auto half_column = [&](std::size_t neuron) {
    return static_cast<long>(2 * grid.column_of(neuron) +
                             (hexagonal ? grid.row_of(neuron) % 2 : 0));
  };
  const long width = 2 * static_cast<long>(grid.columns());
  const auto height = static_cast<long>(grid.rows());
  const long copies = grid.topology() == Topology::kTorus ? 1 : 0;
  long least = -1;
  for (long right = -copies; right <= copies; ++right) {
    for (long down = -copies; down <= copies; ++down) {
      const long x = half_column(a) - half_column(b) + right * width;
      const long y =
          static_cast<long>(grid.row_of(a)) - static_cast<long>(grid.row_of(b)) + down * height;
      const long distance = x * x + (hexagonal ? 3 : 4) * y * y;
      if (least < 0 || distance < least) least = distance;
    }
  }
  return least;
}

// All that could stand for the surroundings, from more votes to fewer, own first, then ascending.
std::size_t slow_surroundings(const MeasuredWinners& problem, std::size_t sample) {
  std::multiset<long> distances;
  for (std::size_t i = 0; i < problem.winners.size(); ++i) {
    if (i == sample) continue;
    distances.insert(exact_distance(problem.grid, problem.winners[sample], problem.winners[i]));
  }
  const std::size_t own = problem.classes[sample];
  if (distances.empty()) return own;
  std::vector<std::pair<std::pair<long, bool>, std::size_t>> order;
  for (std::size_t its_class = 0; its_class < 5; ++its_class) {
    long votes = 0;
    for (std::size_t i = 0; i < problem.winners.size(); ++i) {
      const long distance =
          exact_distance(problem.grid, problem.winners[sample], problem.winners[i]);
      const bool nearest = i != sample && distance == *distances.begin();
      votes += nearest && problem.classes[i] == its_class ? 1 : 0;
    }
    order.push_back({{-votes, its_class != own}, its_class});
  }
  return std::min_element(order.begin(), order.end())->second;
}

TEST(Surroundings, AgreeWithWholeNumbers) {
  Random random(11);
  for (int run = 0; run < 500; ++run) {
    const MeasuredWinners problem = random_winners(random);
    const Numbers found = classes_of_surroundings(problem.grid, problem.winners, problem.classes);
    ASSERT_EQ(found.size(), problem.winners.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i], slow_surroundings(problem, i)) << run << ", sample " << i;
    }
  }
}

TEST(ClassesSeparatedAndSamplesAmbiguous, AgreeWithAllPairs) {
  Random random(12);
  for (int run = 0; run < 500; ++run) {
    const MeasuredWinners problem = random_winners(random);
    const std::set<std::size_t> with_samples(problem.classes.begin(), problem.classes.end());
    std::set<std::size_t> blurred;
    std::set<std::size_t> undetermined;
    for (std::size_t i = 0; i < problem.winners.size(); ++i) {
      for (std::size_t j = 0; j < problem.winners.size(); ++j) {
        const bool shared = problem.winners[i] == problem.winners[j];
        if (!shared || problem.classes[i] == problem.classes[j]) continue;
        undetermined.insert(i);
        blurred.insert(problem.classes[i]);
      }
    }
    const std::vector<bool> separated = separated_classes(problem.winners, problem.classes);
    ASSERT_EQ(separated.size(), *with_samples.rbegin() + 1);
    for (std::size_t its_class = 0; its_class < separated.size(); ++its_class) {
      EXPECT_EQ(separated[its_class],
                with_samples.contains(its_class) && !blurred.contains(its_class));
    }
    EXPECT_EQ(ambiguous_samples(problem.winners, problem.classes), undetermined.size());
  }
}

// The border is all that a frame of one neuron takes away.
TEST(Border, AgreesWithEveryNeuron) {
  Random random(13);
  for (int run = 0; run < 100; ++run) {
    const Grid grid = random_winners(random).grid;
    Numbers all;
    std::size_t there = 0;
    for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
      all.push_back(neuron);
      const std::size_t row = neuron / grid.columns();
      const std::size_t column = neuron % grid.columns();
      const bool inside =
          0 < row && row < grid.rows() - 1 && 0 < column && column < grid.columns() - 1;
      there += inside ? 0 : 1;
    }
    EXPECT_DOUBLE_EQ(border_of(grid), static_cast<double>(there) / static_cast<double>(all.size()));
    EXPECT_DOUBLE_EQ(share_on_border(grid, all), border_of(grid));
  }
}

}  // namespace
}  // namespace somato
