#pragma once

// Random numbers of places, many at a time. Include only from product_kernels_body.h, inside the
// namespace of one instruction set.

constexpr std::size_t kWidth = 8;  // of Words and of a Vector<double>

// Philox4x32-10 for sixteen rows and one quarter after the other. Rows and quarters are two of the
// counter's four words, the others are the same for all. So in the first three rounds, half the
// products depend only on the quarter or only on the row: Quarter and Rows.
constexpr std::uint32_t kFirstFactor = 0xD2511F53U;
constexpr std::uint32_t kSecondFactor = 0xCD9E8D57U;

inline std::uint32_t upper(std::uint64_t product) {
  return static_cast<std::uint32_t>(product >> 32U);
}
inline std::uint32_t lower(std::uint64_t product) {
  return static_cast<std::uint32_t>(product);
}

struct Keys {
  std::uint32_t first[10] = {};
  std::uint32_t second[10] = {};
  explicit Keys(const std::uint32_t* key) {
    for (std::uint32_t round = 0; round < 10; ++round) {
      first[round] = key[0] + round * 0x9E3779B9U;
      second[round] = key[1] + round * 0xBB67AE85U;
    }
  }
};

// The part of the quarter that the third round uses: words by which others are changed.
struct Quarter {
  std::uint32_t with_third;   // the third word after two rounds
  std::uint32_t with_first;   // the first after three
  std::uint32_t with_third2;  // the third after three
  std::uint32_t fourth;       // the fourth after three
};

inline Quarter quarter_words(std::uint32_t quarter, std::uint32_t stream, const Keys& keys) {
  const std::uint64_t first1 = std::uint64_t{kFirstFactor} * quarter;
  const std::uint64_t second1 = std::uint64_t{kSecondFactor} * stream;
  const std::uint32_t third1 = upper(first1) ^ 1U ^ keys.second[0];
  const std::uint64_t second2 = std::uint64_t{kSecondFactor} * third1;
  const std::uint32_t first2 = upper(second2) ^ lower(second1) ^ keys.first[1];
  const std::uint64_t first3 = std::uint64_t{kFirstFactor} * first2;
  return {lower(first1) ^ keys.second[1], lower(second2) ^ keys.first[2],
          upper(first3) ^ keys.second[2], lower(first3)};
}

// The part of eight rows that the rounds use.
struct Rows {
  Words second_upper;  // for the third word after two rounds
  Words fourth;        // the fourth after two

  Rows(const std::uint64_t* rows, std::uint32_t stream, const Keys& keys) {
    const std::uint64_t second1 = std::uint64_t{kSecondFactor} * stream;
    const Words first1 =
        exclusive_or(Words::load(rows), Words::all(upper(second1) ^ keys.first[0]));
    fourth = product_of(first1, Words::all(kFirstFactor));
    second_upper = upper_with(fourth, Words::all(0), Words::all(0));
  }
};

struct FourWords {
  Words words[4];
};

// The rounds from `first` on.
template <std::size_t First>
inline void do_rounds(const Keys& keys, FourWords& x) {
  const Words first_factor = Words::all(kFirstFactor);
  const Words second_factor = Words::all(kSecondFactor);
#pragma GCC unroll 10
  for (std::size_t round = First; round < 10; ++round) {
    const Words first = product_of(x.words[0], first_factor);
    const Words second = product_of(x.words[2], second_factor);
    x.words[0] = upper_with(second, x.words[1], Words::all(keys.first[round]));
    x.words[1] = second;
    x.words[2] = upper_with(first, x.words[3], Words::all(keys.second[round]));
    x.words[3] = first;
  }
}

inline FourWords philox(const Rows& rows, const Quarter& quarter, const Keys& keys) {
  const Words third2 = exclusive_or(rows.second_upper, Words::all(quarter.with_third));
  const Words second3 = product_of(third2, Words::all(kSecondFactor));
  FourWords x{{upper_with(second3, Words::all(quarter.with_first), Words::all(0)), second3,
               exclusive_or(rows.fourth, Words::all(quarter.with_third2)),
               Words::all(quarter.fourth)}};
  do_rounds<3>(keys, x);
  return x;
}

// first, first + 2, first + 4 ...
inline void count_by_two(std::uint64_t first, std::uint64_t* numbers) {
  for (std::uint64_t i = 0; i < kWidth; ++i) numbers[i] = first + 2 * i;
}

void uniform_rows(RandomRows rows, const std::uint32_t* quarters, std::size_t count, float* out) {
  const Keys keys(rows.key);
  std::uint64_t even[kWidth];
  std::uint64_t odd[kWidth];
  count_by_two(rows.first_row, even);
  count_by_two(rows.first_row + 1, odd);
  const Rows even_rows(even, rows.stream, keys);
  const Rows odd_rows(odd, rows.stream, keys);
  for (std::size_t q = 0; q < count; ++q) {
    const Quarter quarter = quarter_words(quarters[q], rows.stream, keys);
    const FourWords a = philox(even_rows, quarter, keys);
    const FourWords b = philox(odd_rows, quarter, keys);
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      uniform_of(a.words[i], b.words[i]).store(out + (4 * q + i) * kRowLanes);
    }
  }
}

// Sixteen quarters of one row at a time.
void uniform_row(RandomRows rows, std::uint32_t first_quarter, std::size_t count, float* out) {
  constexpr std::size_t kTogether = 16;
  const Keys keys(rows.key);
  std::uint64_t quarters[kWidth];
  alignas(64) float numbers[4 * kTogether];
  for (std::size_t q = 0; q < count; q += kTogether) {
    FourWords words[2];
    for (std::uint64_t odd = 0; odd < 2; ++odd) {
      count_by_two(first_quarter + q + odd, quarters);
      words[odd] = {{Words::load(quarters), Words::all(rows.first_row), Words::all(rows.stream),
                     Words::all(1)}};
      do_rounds<0>(keys, words[odd]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      uniform_of(words[0].words[i], words[1].words[i]).store(numbers + i * kTogether);
    }
    const std::size_t left = count - q < kTogether ? count - q : kTogether;
    for (std::size_t k = 0; k < 4 * left; ++k) {
      out[4 * q + k] = numbers[k % 4 * kTogether + k / 4];
    }
  }
}
