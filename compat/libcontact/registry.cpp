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
  if (started_) return true;
  // A folder in front of the experiment's name is the working folder where none is given.
  const std::filesystem::path experiment = name.empty() ? "contact_addon" : name;
  started_ = true;
  working_folder_ = working_folder.empty() ? experiment.parent_path() : std::filesystem::path(working_folder);
  return log_.open(std::filesystem::path(folder) / (experiment.filename().string() + ".out"));
}

void Registry::add(int element, int module) {
  if (element < 1 || element > most_elements)
    throw Refusal(CNTC_err_icp, name_of(element) + ": must be in 1 to " + std::to_string(most_elements));
  if (module != 1 && module != 3)
    throw Refusal(CNTC_err_other, "imodul = " + std::to_string(module) + ": must be 1 or 3");
  const std::lock_guard lock(mutex_);
  const auto [place, is_new] = elements_.try_emplace(element);
  if (!is_new && place->second.module != module)
    throw Refusal(CNTC_err_icp, name_of(element) + " is one of module " + std::to_string(place->second.module));
  place->second.module = module;
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
  log_.close();
}

std::shared_ptr<ContactProblem> Registry::problem(int element, int icp) {
  const std::lock_guard lock(mutex_);
  const auto found = elements_.find(element);
  if (found == elements_.end()) throw Refusal(CNTC_err_icp, "there is no result element " + name_of(element));
  const bool is_wheel = found->second.module == 1;
  const bool is_problem = icp >= 1 && icp <= most_problems;
  if (!is_problem && !(is_wheel && icp == -1))
    throw Refusal(CNTC_err_icp, "icp = " + std::to_string(icp) + ": must be " + (is_wheel ? "-1, or " : "") +
                                    "in 1 to " + std::to_string(most_problems));
  const int number = is_wheel ? -1 : icp;
  auto& problem = found->second.problems[number];
  if (!problem) problem = std::make_shared<ContactProblem>(number);
  return problem;
}

std::filesystem::path Registry::working_folder() {
  const std::lock_guard lock(mutex_);
  return working_folder_;
}

} // namespace microslip::libcontact
