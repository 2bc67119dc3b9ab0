// microslip validate contact --cases: a folder of CONTACT's input files beside its output files.

#include "tests/support/program_run.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// A steel sphere of 100 mm pressed on a plane with 5 kN.
constexpr const char* input = R"(
 3 MODULE
 200100   PBTNFS
 022020   LDCMZE
 0001341  HGIAOWR
 200 30 30 1 1e-6                    MAXGS MAXIN MAXNR MAXOUT EPS
 5000. 0. 0. 0.                      FN CKSI CETA CPHI
 0.3 0.3                             FSTAT FKIN
 0.28 0.28 82000. 82000.             POISS GG
 1                                   IPOTCN
 9 9 -1.8 -1.8 0.4 0.4               MX MY XL YL DX DY
 1 1                                 IBASE IPLAN
 0.005 0. 0.005 0. 0. 0.             B
 0 MODULE
)";

/// The input file in a folder, with what the program prints for it in place of CONTACT's output.
class ContactStudy : public ::testing::Test {
protected:
  void SetUp() override {
    fs::create_directories(folder_ / "cases/below");
    std::ofstream(folder_ / "cases/below/shift.inp") << input;
    const auto run = run_program(folder_, "run cases/below/shift.inp --out -o made");
    ASSERT_EQ(run.exit_code, 0) << run.errors << run.output;
    output_ = contents(folder_ / "made/shift.out");
  }
  void write_output(const std::string& text) { std::ofstream(folder_ / "cases/below/shift.ref_out") << text; }

  TemporaryFolder folder_;
  std::string output_;
};

TEST_F(ContactStudy, AgreesWithItsOwnOutput) {
  write_output(output_);
  const auto outcome = run_program(folder_, "validate contact --cases cases --no-pictures");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
  EXPECT_NE(outcome.output.find("\n  shift "), std::string::npos) << outcome.output;
}

TEST_F(ContactStudy, ListsWhatDiffersWithoutAReason) {
  const std::size_t at = output_.find("5000.");
  ASSERT_NE(at, std::string::npos) << output_;
  write_output(std::string(output_).replace(at, 5, "5100."));
  const auto outcome = run_program(folder_, "validate contact --cases cases --no-pictures");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("Case 1: FN 5000, CONTACT 5100"), std::string::npos) << outcome.output;
}

TEST_F(ContactStudy, RefusesFoldersWithoutCasesAndOtherStudies) {
  const auto refusal = [&](const std::string& arguments) {
    const auto outcome = run_program(folder_, "validate " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    return outcome.errors;
  };
  EXPECT_NE(refusal("contact --cases made").find("no .inp file there has a .ref_out file beside it"),
            std::string::npos);
  EXPECT_NE(refusal("contact --cases none").find("--cases: none is no folder"), std::string::npos);
  EXPECT_NE(refusal("hertz --cases cases").find("--cases: is for the study contact"), std::string::npos);
}

} // namespace
} // namespace microslip
