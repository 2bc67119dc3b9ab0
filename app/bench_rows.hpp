#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::app {

/// Does its work once and returns how many contacts that were. Throws Error if a result is none.
using Work = std::function<std::size_t()>;

/// A line of `microslip bench`: what is measured, and with what it is compared.
struct BenchRow {
  std::string_view name;
  Work work;
  std::string_view over = {}; ///< name of the row that its time is divided by
  double limit = 0;           ///< of this ratio, by design; 0: none
  double seconds = 0;         ///< a contact
};

/// All lines: the simplified theory, the exact theory by kinds of problems, wheels on rails. Their names stay, as
/// `microslip bench --compare` finds a line of another run by its name.
std::vector<BenchRow> bench_rows();

/// A time [s] in a unit that fits.
std::string time_text(double seconds);

} // namespace microslip::app
