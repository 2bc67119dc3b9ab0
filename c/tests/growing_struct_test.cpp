#include "c/growing_struct.hpp"

#include <gtest/gtest.h>

namespace microslip::c {
namespace {

struct First {
  std::size_t struct_size;
  double one;
};
/// Struct of the next version.
struct Second {
  std::size_t struct_size;
  double one, two;
};

TEST(GrowingStruct, AnOlderCallersMissingFieldsAreZero) {
  Second memory = {sizeof(First), 1, 77}; // 77 is not part of the caller's struct
  const Second read = read_growing("options", &memory, sizeof(First));
  EXPECT_EQ(read.one, 1);
  EXPECT_EQ(read.two, 0);
}

TEST(GrowingStruct, ANewerCallersFieldsMustBeZero) {
  Second memory = {sizeof(Second), 1, 0};
  EXPECT_EQ(read_growing("options", reinterpret_cast<First*>(&memory)).one, 1);
  memory.two = 1;
  EXPECT_THROW(read_growing("options", reinterpret_cast<First*>(&memory)), Refusal);
}

TEST(GrowingStruct, WritesNoMoreThanTheCallerHas) {
  Second memory = {0, 0, 77};
  write_growing("result", Second{0, 1, 2}, &memory, sizeof(First), sizeof(First));
  EXPECT_EQ(memory.struct_size, sizeof(First));
  EXPECT_EQ(memory.one, 1);
  EXPECT_EQ(memory.two, 77);
}

TEST(GrowingStruct, ClearsWhatItDoesNotKnow) {
  Second memory = {0, 0, 77};
  write_growing("result", First{0, 1}, reinterpret_cast<First*>(&memory), sizeof(Second));
  EXPECT_EQ(memory.struct_size, sizeof(Second));
  EXPECT_EQ(memory.one, 1);
  EXPECT_EQ(memory.two, 0);
}

TEST(GrowingStruct, RefusesASizeThatWasNeverSet) {
  First memory = {0, 1};
  for (const std::size_t size : {std::size_t{0}, sizeof(First) - 1, largest_struct + 1, ~std::size_t{0}}) {
    memory.struct_size = size;
    EXPECT_THROW(read_growing("options", &memory), Refusal);
    EXPECT_THROW(write_growing("result", First{}, &memory, size), Refusal);
  }
  EXPECT_THROW(read_growing<First>("options", nullptr), Refusal);
}

} // namespace
} // namespace microslip::c
