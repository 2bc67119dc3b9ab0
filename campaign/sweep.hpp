#pragma once

#include "campaign/campaign.hpp"
#include "campaign/sweep_spec.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::campaign {

/// A number that is kept of every case: the dataset of result files that it goes to, "contact/fx".
struct SweepColumn {
  std::string path, unit, description;
};

/// The last part of the path of a sweep's second column.
inline constexpr std::string_view warning_name = "warning_code";

/// The cases of a specification as rows of a campaign. The first number of a row is the status, by its index in Status,
/// the second one the code of its Warnings.
class Sweep {
public:
  /// Reads a specification and the files it names. Throws Error as SweepSpec, or if none of some of its cases can be
  /// read: with what is wrong with the first one.
  Sweep(const std::string& text, const std::string& name);

  const SweepSpec& spec() const { return *spec_; }
  const std::vector<SweepColumn>& columns() const { return columns_; }
  CampaignPlan plan() const;

  /// A worker with separate solvers, for one thread. A row depends on its index alone; cost beside that of the
  /// solution: some 10 microseconds to read the case, or, if its profiles are others than the case's before, what it
  /// takes to prepare these.
  RowWorker make_worker() const { return make_worker_(); }

private:
  template <class Kind> void set_up(SweepSpec spec);

  std::shared_ptr<const SweepSpec> spec_;
  std::vector<SweepColumn> columns_;
  std::function<RowWorker()> make_worker_;
};

} // namespace microslip::campaign
