#pragma once

#include "io/contact_run.hpp"
#include "io/result_file.hpp"

#include <filesystem>

namespace microslip {

/// The result file of `microslip run`, SI units. `cases/...` have a value for each case of the input file; those of a
/// case that was not solved are NaN, and counts zero. `elements/...` have the elements that digit A asks for, of all
/// cases one after the other: those of a case begin at cases/first_element.
class ContactRunFile {
public:
  ContactRunFile(const std::filesystem::path& path, const Provenance& provenance);

  void add(const ContactCase& c, const ContactOutcome& outcome);
  void commit() { file_.commit(); }

private:
  int add_elements(const ContactCase& c, const ContactOutcome& outcome);

  ResultFile file_;
  double elements_ = 0; ///< stored so far
};

} // namespace microslip
