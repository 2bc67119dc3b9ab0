#include "io/sha256.hpp"

#include "microslip/error.hpp"
#include "tests/support/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// The examples of FIPS 180-4: no byte, three, 56 (two blocks) and a million.
TEST(Sha256, OfTheStandardsExamples) {
  EXPECT_EQ(io::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(io::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(io::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(io::sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  const std::string bytes("a\r\n\0\xff", 5);
  save(folder / "file", bytes);
  EXPECT_EQ(io::sha256_of_file(folder / "file"), io::sha256(bytes));
  EXPECT_THROW(io::sha256_of_file(folder / "none"), Error);
}

} // namespace
} // namespace microslip
