#include "studies/run/journal.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "base/support/sanitized.h"
#include "base/support/temporary_folder.h"
#include "studies/run/checked_line.h"

namespace somato {
namespace {

// Damaged places are tried at every step: each, or under a sanitizer some.
constexpr std::size_t kStep = testing::fewer_if_sanitized(8) == 8 ? 1 : 9;

const std::string kStudy = "a study\nof this data\n";

FoldOutcome outcome_number(std::size_t number) {
  FoldOutcome outcome;
  outcome.training_winners = {3, number, 2};
  outcome.winners = {number, 7};
  outcome.named_by = {1, number};
  outcome.nearest.raw = {0, 0};
  outcome.nearest.standardized = {number, 1};
  outcome.summed_distance = 0.1 + static_cast<double>(number) / 3.0;
  outcome.topographic_errors = 1.0 / 7.0;
  outcome.altered = {{{number, 5}, {{number}, {6}}}, AlteredOutcome{}};
  outcome.recalled = {number, 3};
  outcome.map.grid = number % 2 == 0 ? Grid(4, 3, Lattice::kHexagonal, Topology::kTorus)
                                     : Grid(std::make_shared<const NeuronGraph>(
                                           3, std::vector<NeuronGraph::Edge>{{0, 2}, {1, 2}}));
  outcome.map.u_matrix = {1.0 / 7.0, static_cast<double>(number)};
  outcome.map.edge_distances = {static_cast<double>(number) / 3.0};
  if (number == 1) outcome.novelty = {{{0.1, 1.0 / 3.0}, {2.0}, {}}, {{3.0}, {}, {4.0}}};
  if (number == 1) {
    outcome.teaching = {
        {{{1, 2, 3}, {4, 5, 6}, 7}, {{8, 9, 10}, {11, 12, 13}, 14}}, 15, 16, 17, 18};
  }
  const double third = static_cast<double>(number) / 3.0;
  outcome.predictions = {{third, 1.0, 2.0, {0.1, 3.0, 0.4}, {5.0}, {6.0}, {7.0}, {8.0}, {9.0}},
                         PredictionOutcome{}};
  outcome.objects = {
      {number, 2}, {{{{1}, {0, number}}, 5}, {{{2}, {1, 1}}, number}}, 3, number, {number, 1}};
  return outcome;
}

class JournalFile : public ::testing::Test {
 protected:
  std::string path() const { return folder_.file("journal"); }
  Journal open() const { return Journal::open(path(), kStudy).value(); }

  // Replaces the file. File systems write a file that is truncated instead to the disk at once.
  void write(const std::string& bytes) const {
    std::filesystem::remove(path());
    folder_.with("journal", bytes);
  }

  // The first trainings of protocol 1.
  std::string write_some(std::size_t count = 5) const {
    Journal journal = open();
    for (std::size_t number = 0; number < count; ++number) {
      EXPECT_TRUE(journal.add(1, number, outcome_number(number)));
    }
    return bytes_of(path());
  }

  void expect_refused(const std::string& bytes, ErrorKind kind, const std::string& advice) const {
    write(bytes);
    const auto journal = Journal::open(path(), kStudy);
    ASSERT_FALSE(journal) << bytes;
    EXPECT_EQ(journal.error().kind, kind) << bytes;
    EXPECT_EQ(journal.error().where, path());
    EXPECT_NE(journal.error().advice.find(advice), std::string::npos) << journal.error().advice;
    EXPECT_TRUE(bytes_of(path()) == bytes);
  }

  TemporaryFolder folder_;
};

TEST_F(JournalFile, KeepsEveryBitOfATraining) {
  write_some();
  const Journal journal = open();
  for (std::size_t number = 0; number < 5; ++number) {
    ASSERT_NE(journal.find(1, number), nullptr);
    EXPECT_EQ(*journal.find(1, number), outcome_number(number));
  }
  EXPECT_EQ(journal.find(0, 0), nullptr);
  EXPECT_EQ(journal.find(1, 5), nullptr);
}

TEST_F(JournalFile, IsNotMadeBeforeThereIsSomethingToKeep) {
  Journal journal = open();
  EXPECT_EQ(journal.find(0, 0), nullptr);
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(JournalFile, WithoutAPathNothingIsKept) {
  Journal journal;
  EXPECT_TRUE(journal.add(0, 0, outcome_number(0)));
  EXPECT_EQ(journal.find(0, 0), nullptr);
}

TEST_F(JournalFile, ContinuesWhereItWas) {
  write_some();
  EXPECT_TRUE(open().add(0, 9, outcome_number(9)));
  const Journal journal = open();
  EXPECT_EQ(*journal.find(0, 9), outcome_number(9));
  EXPECT_EQ(*journal.find(1, 4), outcome_number(4));
}

// For any cut, the whole lines before are known, and the journal can be continued.
TEST_F(JournalFile, MayBeCutAtEveryByte) {
  const std::string whole = write_some(3);
  for (std::size_t size = 0; size < whole.size(); size += kStep) {
    const std::string cut = whole.substr(0, size);
    write(cut);
    const auto lines = std::count(cut.begin(), cut.end(), '\n');
    const std::size_t known = lines == 0 ? 0 : static_cast<std::size_t>(lines) - 1;
    Journal journal = open();
    for (std::size_t number = 0; number < 3; ++number) {
      ASSERT_EQ(journal.find(1, number) != nullptr, number < known) << size;
    }
    for (std::size_t number = known; number < 3; ++number) {
      ASSERT_TRUE(journal.add(1, number, outcome_number(number)));
    }
    ASSERT_TRUE(bytes_of(path()) == whole) << size;
  }
}

// Every flipped bit must be detected, since it could change a result. A flipped line end joins two
// lines to one that does not match its checksum. Every seventh bit is flipped, so that each byte
// and each place in a byte occurs.
TEST_F(JournalFile, WithATurnedBitIsKnownUpToItsLine) {
  const std::string whole = write_some(3);
  const std::size_t header = whole.find('\n') + 1;
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 7 * kStep) {
    std::string turned = whole;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << bit % 8));
    if (bit / 8 < header) {
      expect_refused(turned, ErrorKind::kData, "remove it to restart the study");
      continue;
    }
    write(turned);
    const Journal journal = open();
    const auto sound = static_cast<std::size_t>(
        std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bit / 8), '\n') - 1);
    for (std::size_t number = 0; number < 3; ++number) {
      ASSERT_EQ(journal.find(1, number) != nullptr, number < sound) << bit;
      if (number < sound) {
        ASSERT_EQ(*journal.find(1, number), outcome_number(number));
      }
    }
  }
}

TEST_F(JournalFile, ContinuesAfterADamagedLine) {
  const std::string whole = write_some(3);
  std::string turned = whole;
  turned[turned.size() / 2] ^= 1;
  write(turned);
  Journal journal = open();
  for (std::size_t number = 0; number < 3; ++number) {
    if (journal.find(1, number) != nullptr) continue;
    ASSERT_TRUE(journal.add(1, number, outcome_number(number)));
  }
  EXPECT_TRUE(bytes_of(path()) == whole);
}

TEST_F(JournalFile, OfAnotherStudyIsRefused) {
  write_some();
  const std::string bytes = bytes_of(path());
  const auto other = Journal::open(path(), kStudy + "with other settings");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().kind, ErrorKind::kUsage);
  EXPECT_NE(other.error().advice.find("use another folder"), std::string::npos);
  EXPECT_TRUE(bytes_of(path()) == bytes);
}

// The first version had no checksums.
TEST_F(JournalFile, OfAnotherFormatIsRefusedWithItsVersion) {
  const std::string advice = "complete that study with that version";
  expect_refused("{\"somato_journal\":1,\"study\":\"a\"}\n", ErrorKind::kData, advice);
  expect_refused(checked_line({{"somato_journal", 7}, {"study", kStudy}}), ErrorKind::kData,
                 advice);
  write(checked_line({{"somato_journal", 9}, {"study", kStudy}}));
  EXPECT_EQ(to_string(Journal::open(path(), kStudy).error()),
            path() +
                ": written by a newer version of Somato (format 9, supported is 8); "
                "update Somato");
}

TEST_F(JournalFile, RefusesWhatIsNoJournal) {
  const std::string advice = "remove it to restart the study";
  for (const std::string other : {"notes", "notes\nof mine\n", "{}\n", "00000000 \n", "\n",
                                  "{\"somato_journal\":\"8\"}\n", "[8]\n"}) {
    expect_refused(other, ErrorKind::kData, advice);
  }
  std::filesystem::remove(path());
  std::filesystem::create_directory(path());
  const auto journal = Journal::open(path(), kStudy);
  ASSERT_FALSE(journal);
  EXPECT_NE(to_string(journal.error()).find(path()), std::string::npos);
}

TEST_F(JournalFile, SaysWhenItCannotBeWritten) {
  const std::string missing = folder_.file("missing/journal");
  Journal journal = Journal::open(missing, kStudy).value();
  const auto added = journal.add(0, 0, outcome_number(0));
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(added.error().where, missing);
  EXPECT_NE(added.error().advice.find("choose a writable folder"), std::string::npos);
}

TEST_F(JournalFile, IsWrittenByThreadsLineByLine) {
  Journal journal = open();
  std::vector<std::thread> threads;
  threads.reserve(4);
  std::atomic<int> failed = 0;
  for (std::size_t thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (std::size_t i = 0; i < 200; ++i) {
        if (!journal.add(thread, i, outcome_number(i))) ++failed;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failed, 0);
  const Journal known = open();
  for (std::size_t thread = 0; thread < 4; ++thread) {
    for (std::size_t i = 0; i < 200; ++i) {
      ASSERT_NE(known.find(thread, i), nullptr);
      ASSERT_EQ(*known.find(thread, i), outcome_number(i));
    }
  }
}

}  // namespace
}  // namespace somato
