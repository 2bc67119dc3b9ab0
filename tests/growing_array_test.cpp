// Result files that grow: arrays that are written piece by piece, to memory or to disk.

#include "io/result_file.hpp"
#include "microslip/error.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Storage = io::ResultFile::Storage;

TEST(GrowingArray, PiecesBecomeOneArray) {
  for (const auto storage : {Storage::memory, Storage::disk}) {
    const TemporaryFolder folder;
    std::vector<double> all;
    {
      io::ResultFile file(folder / "a.h5", {.kind = "test"}, storage);
      for (int n : {3, 0, 5000, 1}) {
        std::vector<double> piece(static_cast<std::size_t>(n));
        std::iota(piece.begin(), piece.end(), static_cast<double>(all.size()));
        file.append("group/values", std::span<const double>(piece), "m", "a row");
        all.insert(all.end(), piece.begin(), piece.end());
      }
      const std::vector<int> counts = {7, 8};
      file.append("counts", std::span<const int>(counts), "-", "two");
      file.append("nothing", std::span<const int>(), "-", "none");
      file.commit();
    }
    const Hdf5Reader reader(folder / "a.h5");
    EXPECT_EQ(reader.values<double>("group/values", H5T_NATIVE_DOUBLE), all);
    EXPECT_EQ(reader.values<int>("counts", H5T_NATIVE_INT), (std::vector<int>{7, 8}));
    EXPECT_EQ(reader.shape("nothing"), std::vector<hsize_t>{0});
    EXPECT_EQ(reader.attribute("group/values", "unit"), "m");
    EXPECT_EQ(reader.attribute("/", "kind"), "test");
    EXPECT_EQ(folder.entries(), std::vector<std::string>{"a.h5"});
  }
}

TEST(GrowingArray, WithoutCommitNothingIsLeft) {
  const TemporaryFolder folder;
  {
    io::ResultFile file(folder / "a.h5", {}, Storage::disk);
    const std::vector<double> values(100000, 1.0);
    file.append("values", std::span<const double>(values), "m", "many");
    EXPECT_EQ(folder.entries().size(), 1u);
  }
  EXPECT_TRUE(folder.entries().empty());
}

TEST(GrowingArray, AFolderThatCannotBeWrittenFailsAtOnce) {
  const TemporaryFolder folder;
  EXPECT_THROW(io::ResultFile(folder / "none" / "a.h5", {}, Storage::disk), Error);
}

} // namespace
} // namespace microslip
