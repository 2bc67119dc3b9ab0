#pragma once

#include "compat/libcontact/case_file.hpp"
#include "compat/libcontact/contact_problem.hpp"
#include "compat/libcontact/log.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace microslip::libcontact {

/// The result elements that there are, by their numbers. This is the library's only state beyond a call: the interface
/// names result elements by numbers that its caller chooses, and has one log, and one input file, for all of them.
///
/// The registry's mutex is held for look-ups only; work on a problem requires the mutex of the problem. A problem
/// that is finalized while a thread works on it lives until that thread is done.
class Registry {
public:
  static constexpr int most_elements = 999, most_problems = 9;

  static Registry& instance();

  /// Opens the log and remembers the folders, unless that has been done already. Returns whether the log can be
  /// written.
  bool start(const std::string& working_folder, const std::string& folder, const std::string& name);
  /// Throws Refusal for an element that is there as one of another module, for numbers of elements and modules that
  /// do not exist.
  void add(int element, int module);
  /// Throws Refusal if there is no such element.
  void remove(int element);
  void remove_all();

  /// Module of an existing element.
  std::optional<int> module(int element);
  /// The problem of a call with `icp`: in module 1 that of the wheel, whatever its patch. Begins the library and adds
  /// the element if there is none. Throws Refusal as add does, and for an icp that does not exist.
  std::shared_ptr<ContactProblem> problem(int element, int module, int icp);
  /// Folder of profiles.
  std::filesystem::path working_folder();
  /// Folder of the log and all other files.
  std::filesystem::path output_folder();
  Log& log() { return log_; }
  CaseFile& cases() { return cases_; }

private:
  struct Element {
    int module = 0;
    std::map<int, std::shared_ptr<ContactProblem>> problems;
  };

  // With the mutex held.
  bool begin(const std::string& working_folder, const std::string& folder, const std::string& name);
  Element& element(int number, int module);
  void stop();

  std::mutex mutex_;
  bool started_ = false;
  std::filesystem::path working_folder_, output_folder_;
  std::map<int, Element> elements_;
  Log log_;
  CaseFile cases_;
};

} // namespace microslip::libcontact
