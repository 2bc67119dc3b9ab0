#pragma once

#include "tests/contact_input_cases.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace microslip::contact_program {

/// A circle of 100 mm, z downwards.
inline double convex(double y) {
  return 100 - std::sqrt(1e4 - y * y);
}

/// A folder with profiles 40 mm wide, and the cases of texts that lie in it. The wheel's profile is a circle of 100 mm:
/// with a radius of 100 mm it is a sphere.
class ProfileFolder : public ::testing::Test {
protected:
  ProfileFolder() {
    write("wheel.prw", 1, [](double y) { return -convex(y); });
    write("convex.prr", 0, convex);
  }

  void write(const std::string& name, int type, const std::function<double(double)>& z) const {
    write_at(name, type, type == 0 ? equal_steps(-20, 20, 401) : equal_steps(20, -20, 401), z);
  }

  /// With points at these y.
  void write_at(const std::string& name, int type, const std::vector<double>& places,
                const std::function<double(double)>& z) const {
    std::ofstream file(folder_ / name);
    file.precision(15);
    file << "header.begin\n version = 1\n type = " << type << "\nheader.end\nspline.begin\n units.len.f = 1000.\n";
    file << " point.begin\n";
    for (const double y : places) file << y << " " << z(y) << "\n";
    file << " point.end\nspline.end\n";
  }

  std::string file() const { return folder_ / "a.inp"; }
  std::vector<Outcome> run(const std::string& text) const { return outcomes_of(text, file()); }
  /// Why the cases of a text are refused.
  std::vector<std::string> refusal(const std::string& text) const {
    return run_cases(text, file()).at(0).outcome.reasons;
  }

  TemporaryFolder folder_;
};

} // namespace microslip::contact_program
