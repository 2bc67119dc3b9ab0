#include "io/json.hpp"
#include "tests/support/numbers.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(Json, NumbersReadBackAsTheSame) {
  for (const double value : {0.1, -1.0 / 3, 1e300, 5e-324, 0.0})
    EXPECT_EQ(io::Json::parse(io::json_text(io::json_number(value))).get<double>(), value);
}

TEST(Json, NumbersThatAreNotFiniteAreWords) {
  EXPECT_EQ(io::json_text(io::json_number(infinity)), "\"inf\"\n");
  EXPECT_EQ(io::json_text(io::json_number(-infinity)), "\"-inf\"\n");
  EXPECT_EQ(io::json_text(io::json_number(std::numeric_limits<double>::quiet_NaN())), "\"nan\"\n");
}

TEST(Json, KeepsTheOrderOfMembers) {
  EXPECT_EQ(io::json_text({{"b", 1}, {"a", {1, 2}}}), "{\n  \"b\": 1,\n  \"a\": [\n    1,\n    2\n  ]\n}\n");
}

TEST(Json, TextOfAnyBytesIsJson) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) bytes += static_cast<char>(byte);
  const auto text = io::json_text(bytes);
  EXPECT_TRUE(io::Json::accept(text));
  EXPECT_EQ(io::Json::parse(text).get<std::string>().substr(0, 128), bytes.substr(0, 128));
  EXPECT_EQ(io::Json::parse(io::json_text("Räder")).get<std::string>(), "Räder");
}

} // namespace
} // namespace microslip
