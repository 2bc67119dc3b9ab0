#pragma once

#include "compat/contact/run.hpp"
#include "io/result_file.hpp"

#include <filesystem>

namespace microslip::contact_program {

/// The result file of `microslip run`, SI units. `cases/...` have a value for each case of the input file; those of a
/// case that was not solved are NaN, and counts zero. `elements/...` have the elements that digit A asks for, of all
/// cases one after the other: those of a case begin at cases/first_element. So do `interior/...` with the points inside
/// the bodies that digit S asks for, from cases/first_point on.
class RunFile {
public:
  RunFile(const std::filesystem::path& path, const Provenance& provenance);

  void add(const Case& c, const Outcome& outcome);
  void commit() { file_.commit(); }

private:
  int add_elements(const Case& c, const Outcome& outcome);
  int add_points(const Outcome& outcome);

  ResultFile file_;
  double elements_ = 0, points_ = 0; ///< stored so far
};

} // namespace microslip::contact_program
