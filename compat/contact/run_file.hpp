#pragma once

#include "compat/contact/run.hpp"
#include "io/result_file.hpp"

#include <filesystem>

namespace microslip {

/// The result file of `microslip run`, SI units. `cases/...` have a value for each case of the input file; those of a
/// case that was not solved are NaN, and counts zero. `elements/...` have the elements that digit A asks for, of all
/// cases one after the other: those of a case begin at cases/first_element. So do `interior/...` with the points inside
/// the bodies that digit S asks for, from cases/first_point on.
class ContactRunFile {
public:
  ContactRunFile(const std::filesystem::path& path, const Provenance& provenance);

  void add(const ContactCase& c, const ContactOutcome& outcome);
  void commit() { file_.commit(); }

private:
  int add_elements(const ContactCase& c, const ContactOutcome& outcome);
  int add_points(const ContactOutcome& outcome);

  ResultFile file_;
  double elements_ = 0, points_ = 0; ///< stored so far
};

} // namespace microslip
