#include "report/chunk.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "inflate.hpp"
#include "report/quantise.hpp"

namespace washtub {
namespace {

/// Bytes that do not repeat, longer than a line or a block of any encoder.
std::string noise(std::size_t count) {
  std::string bytes;
  unsigned state = 1;
  while (bytes.size() < count) {
    state = state * 1664525U + 1013904223U;
    bytes += static_cast<char>(state >> 24);
  }
  return bytes;
}

TEST(Chunks, GiveBackWhatWasAdded) {
  Chunks chunks;
  for (const std::size_t count : {0UL, 1UL, 2UL, 3UL, 5000000UL}) {
    const std::string bytes = noise(count);
    const int number = chunks.add(std::string_view(bytes));
    EXPECT_EQ(inflate(chunks.texts()[static_cast<std::size_t>(number)]), bytes);
  }
  EXPECT_EQ(chunks.texts()[4].find('\n'), std::string::npos);
}

TEST(Chunks, PartsMakeOneChunk) {
  const std::string bytes = noise(100000);
  Deflater deflater;
  for (std::size_t i = 0; i < bytes.size(); i += 999)
    deflater.add(std::string_view(bytes).substr(i, 999));
  Chunks chunks;
  chunks.add(deflater);
  EXPECT_EQ(inflate(chunks.texts()[0]), bytes);
}

TEST(Chunks, SizeIsThatOfTheirElements) {
  Chunks chunks;
  std::size_t bytes = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    chunks.add(std::string_view(noise(1000 * n)));
    bytes += chunk_element(n, chunks.texts()[n]).size();
  }
  EXPECT_EQ(chunks.size(), bytes);
}

TEST(Quantise, HalfAStepIsTheLargestError) {
  for (double x = -0.3; x <= 0.7; x += 0.0123) {
    const double q = quantise_linear(x, -0.3, 0.7);
    EXPECT_NEAR(-0.3 + q / 65535, x, 0.5001 / 65535);
    const double root = quantise_root(std::abs(x), 0.7);
    EXPECT_NEAR(root / 65535, std::sqrt(std::abs(x) / 0.7), 0.5001 / 65535);
    const double c = quantise_companded(x, 0.7);
    EXPECT_NEAR(c / 127, std::copysign(std::sqrt(std::abs(x) / 0.7), x), 0.5001 / 127);
  }
}

TEST(Quantise, EndsAreReached) {
  EXPECT_EQ(quantise_linear(2, 1, 2), 65535);
  EXPECT_EQ(quantise_linear(1, 1, 2), 0);
  EXPECT_EQ(quantise_root(3, 3), 65535);
  EXPECT_EQ(quantise_companded(-3, 3), -127);
  EXPECT_EQ(quantise_companded(3, 3), 127);
}

TEST(Quantise, WhatIsNoNumberIsZero) {
  const double nan = std::nan(""), infinity = 1 / 0.0;
  EXPECT_EQ(quantise_linear(nan, 0, 1), 0);
  EXPECT_EQ(quantise_linear(1, 1, 1), 0);
  EXPECT_EQ(quantise_root(infinity, 1), 0);
  EXPECT_EQ(quantise_root(-1, 1), 0);
  EXPECT_EQ(quantise_companded(nan, 1), 0);
  EXPECT_EQ(quantise_companded(0, 0), 0);
  const std::vector<float> values = {1, -4, static_cast<float>(nan), static_cast<float>(infinity)};
  EXPECT_EQ(largest_magnitude(values), 4);
}

}  // namespace
}  // namespace washtub
