#include "io/result_json.hpp"

#include "io/hdf5_handle.hpp"
#include "io/json_result.hpp"
#include "io/result_file.hpp"
#include "microslip/version.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cstdint>
#include <fstream>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(ResultJson, HasGroupsUnitsAndAttributes) {
  const TemporaryFolder folder;
  {
    io::ResultFile file(folder / "r.h5", {.kind = "test", .title = "T", .case_text = "a = 1\n"});
    file.scalar("exact/fx", -1.25, "N", "force");
    file.scalar("exact/limit/error", infinity, "mu Fn", "error");
    file.text("exact/status", "ok", "how it ended");
    file.array("curve/fx", std::vector<double>{0, 0.1, std::numeric_limits<double>::quiet_NaN()}, "N", "forces");
    file.array("curve/count", std::vector<int>{3, -4}, "-", "counts");
    file.append("cases/fy", std::vector<double>{2.5}, "N", "grows");
    file.append("cases/fy", std::vector<double>{3.5}, "N", "grows");
    file.attribute("curve", "variable", "spin");
    file.commit();
  }
  const auto json = io::result_json(folder / "r.h5");
  EXPECT_EQ(json.at("kind"), "test");
  EXPECT_EQ(json.at("title"), "T");
  EXPECT_EQ(json.at("case_text"), "a = 1\n");
  EXPECT_EQ(json.at("version"), build_info().version);
  EXPECT_EQ(json.at("exact"), io::Json::parse(R"({"fx": -1.25, "limit": {"error": "inf"}, "status": "ok"})"));
  EXPECT_EQ(json.at("curve"), io::Json::parse(R"({"variable": "spin", "count": [3, -4], "fx": [0.0, 0.1, "nan"]})"));
  EXPECT_EQ(json.at("cases").at("fy"), io::Json::parse("[2.5, 3.5]"));
  EXPECT_EQ(json.at("units"), io::Json::parse(R"({"cases/fy": "N", "curve/count": "-", "curve/fx": "N", "exact/fx": "N",
                                              "exact/limit/error": "mu Fn"})"));
}

TEST(ResultJson, HasNamesOfAnyLength) {
  // Sweeps name groups by all the parameters that vary together.
  const TemporaryFolder folder;
  for (const std::size_t length : {255, 256, 300, 5000}) {
    const std::string group(length, 'g'), dataset(length, 'd'), attribute(length, 'a');
    {
      io::ResultFile file(folder / "r.h5", {});
      file.scalar(group + "/" + dataset, 2.5, "m", "a number");
      file.attribute(group, attribute, "a text");
      file.commit();
    }
    const auto json = io::result_json(folder / "r.h5");
    EXPECT_EQ(json.at(group).at(dataset), 2.5) << length;
    EXPECT_EQ(json.at(group).at(attribute), "a text") << length;
  }
}

TEST(ResultJson, RefusesAFormatOfLaterVersions) {
  const TemporaryFolder folder;
  {
    io::ResultFile file(folder / "now.h5", {});
    file.commit();
    const io::Hdf5Handle later(H5Fcreate((folder / "later.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                               H5Fclose),
        space(H5Screate(H5S_SCALAR), H5Sclose), type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), H5T_VARIABLE);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    const io::Hdf5Handle format(H5Acreate2(later.get(), "format", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
                                H5Aclose);
    const char* const number = "3";
    H5Awrite(format.get(), type.get(), static_cast<const void*>(&number));
  }
  EXPECT_EQ(io::result_json(folder / "now.h5").at("format"), "2");
  EXPECT_EQ(error_of([&] { io::result_json(folder / "later.h5"); }),
            (folder / "later.h5").string() + ": has format 3 of result files; this version of microslip reads 2");
}

TEST(ResultJson, LeavesFieldsOut) {
  const TemporaryFolder folder;
  {
    io::ResultFile file(folder / "r.h5", {});
    file.array("exact/fields/px", std::vector<double>{1, 2, 3, 4}, "Pa", "traction", {2, 2});
    file.array("elements/px", std::vector<double>{1, 2}, "Pa", "traction");
    file.array("interior/z", std::vector<double>{1, 2}, "m", "depth");
    file.array("table", std::vector<std::uint8_t>{1, 2, 3, 4}, "-", "of two dimensions", {2, 2});
    file.scalar("exact/fx", 1, "N", "force");
    file.commit();
  }
  const auto json = io::result_json(folder / "r.h5");
  EXPECT_EQ(json.at("exact"), io::Json::parse(R"({"fx": 1.0})"));
  for (const auto* name : {"elements", "interior", "table"}) EXPECT_FALSE(json.contains(name)) << name;
  EXPECT_EQ(json.at("units"), io::Json::parse(R"({"exact/fx": "N"})"));
}

void write_all_kinds(io::ResultWriter& result) {
  result.scalar("exact/fx", -1.25, "N", "force");
  result.scalar("exact/limit/elements", 32, "-", "a number of that name is no field");
  result.text("inputs/elements", "bilinear", "nor a text");
  result.array("exact/fields/px", std::vector<double>{1, 2, 3, 4}, "Pa", "traction", {2, 2});
  result.array("elements/px", std::vector<double>{1, 2}, "Pa", "traction");
  result.array("interior/z", std::vector<double>{1, 2}, "m", "depth");
  result.array("table", std::vector<std::uint8_t>{1, 2, 3, 4}, "-", "of two dimensions", {2, 2});
  result.array("curve/fx", std::vector<double>{0, infinity}, "N", "forces");
  result.array("curve/count", std::vector<int>{3, -4}, "-", "counts");
  result.array("curve/state", std::vector<std::uint8_t>{1, 2}, "-", "states");
  result.attribute("curve", "variable", "spin");
}

/// States and patches are elements of lists, layers are counted from 1 on.
TEST(ResultJson, PlacesAreThoseOfListsButAmongInputs) {
  io::JsonResult result({});
  result.scalar("patches/0/fx", 1, "N", "force");
  result.scalar("patches/1/fx", 2, "N", "force");
  result.scalar("inputs/body1/layers/1/thickness", 3, "m", "thickness");
  result.scalar("inputs/body1/layers/2/thickness", 4, "m", "thickness");
  const io::Json json = result.document();
  EXPECT_EQ(json.at("patches"), io::Json::parse(R"([{"fx": 1.0}, {"fx": 2.0}])"));
  EXPECT_EQ(json.at("inputs").at("body1").at("layers"),
            io::Json::parse(R"({"1": {"thickness": 3.0}, "2": {"thickness": 4.0}})"));
}

TEST(ResultJson, IsWhatJsonResultMakesWithoutAFile) {
  const TemporaryFolder folder;
  const io::Provenance provenance = {.kind = "test", .title = "T"};
  io::ResultFile file(folder / "r.h5", provenance);
  write_all_kinds(file);
  file.commit();
  io::JsonResult direct(provenance);
  write_all_kinds(direct);
  // In no order: that of HDF5 is the alphabet's.
  nlohmann::json read = io::result_json(folder / "r.h5"), made = direct.document();
  for (auto* document : {&read, &made}) document->erase("created");
  EXPECT_EQ(read, made);
  EXPECT_EQ(read.at("exact").at("limit").at("elements"), 32);
  EXPECT_EQ(read.at("inputs").at("elements"), "bilinear");
}

TEST(ResultJson, RefusesWhatIsNoResultFile) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.h5") << "no HDF5";
  for (const auto* name : {"text.h5", "none.h5"}) {
    const auto path = folder / name;
    EXPECT_EQ(error_of([&] { io::result_json(path); }), path.string() + ": cannot be read as HDF5");
  }
}

} // namespace
} // namespace microslip
