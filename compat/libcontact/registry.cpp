#include "compat/libcontact/registry.hpp"

#include "compat/libcontact/refusal.hpp"

namespace microslip::libcontact {
namespace {

std::string name_of(int element) {
  return "ire = " + std::to_string(element);
}

} // namespace

Registry& Registry::instance() {
  static Registry registry;
  return registry;
}

bool Registry::start(const std::string& working_folder, const std::string& folder, const std::string& name) {
  const std::lock_guard lock(mutex_);
  return begin(working_folder, folder, name);
}

bool Registry::begin(const std::string& working_folder, const std::string& folder, const std::string& name) {
  if (started_) return true;
  // A folder in front of the experiment's name is the working folder where none is given.
  const std::filesystem::path experiment = name.empty() ? "contact_addon" : name;
  started_ = true;
  working_folder_ = working_folder.empty() ? experiment.parent_path() : std::filesystem::path(working_folder);
  output_folder_ = folder;
  const std::string file = experiment.filename().string();
  cases_.set_path(output_folder_ / (file + ".inp"));
  return log_.open(output_folder_ / (file + ".out"));
}

void Registry::add(int number, int module) {
  const std::lock_guard lock(mutex_);
  element(number, module);
}

/// The element, which is added if it is not there yet.
Registry::Element& Registry::element(int number, int module) {
  if (number < 1 || number > most_elements)
    throw Refusal(CNTC_err_icp, name_of(number) + ": must be in 1 to " + std::to_string(most_elements));
  if (module != 1 && module != 3)
    throw Refusal(CNTC_err_other, "imodul = " + std::to_string(module) + ": must be 1 or 3");
  Element& found = elements_[number];
  if (found.module == 0) found.module = module;
  if (found.module != module)
    throw Refusal(CNTC_err_icp, name_of(number) + " is one of module " + std::to_string(found.module));
  return found;
}

std::optional<int> Registry::module(int element) {
  const std::lock_guard lock(mutex_);
  const auto found = elements_.find(element);
  return found == elements_.end() ? std::optional<int>() : found->second.module;
}

void Registry::remove(int element) {
  const std::lock_guard lock(mutex_);
  if (elements_.erase(element) == 0) throw Refusal(CNTC_err_icp, "there is no result element " + name_of(element));
  if (elements_.empty()) stop();
}

void Registry::remove_all() {
  const std::lock_guard lock(mutex_);
  elements_.clear();
  stop();
}

void Registry::stop() {
  started_ = false;
  cases_.close();
  log_.close();
}

std::shared_ptr<ContactProblem> Registry::problem(int number, int module, int icp) {
  const bool is_wheel = module == 1, is_problem = icp >= 1 && icp <= most_problems;
  if (!is_problem && !(is_wheel && icp == -1))
    throw Refusal(CNTC_err_icp, "icp = " + std::to_string(icp) + ": must be " + (is_wheel ? "-1, or " : "") +
                                    "in 1 to " + std::to_string(most_problems));
  const std::lock_guard lock(mutex_);
  Element& of = element(number, module);
  if (!started_) begin("", "", "");
  const int key = is_wheel ? -1 : icp;
  auto& problem = of.problems[key];
  if (!problem) problem = std::make_shared<ContactProblem>(number, key);
  return problem;
}

std::filesystem::path Registry::working_folder() {
  const std::lock_guard lock(mutex_);
  return working_folder_;
}

std::filesystem::path Registry::output_folder() {
  const std::lock_guard lock(mutex_);
  return output_folder_;
}

} // namespace microslip::libcontact
