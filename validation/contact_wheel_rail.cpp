#include "validation/studies.hpp"

#include "compat/contact/input.hpp"
#include "compat/contact/run.hpp"
#include "microslip/error.hpp"
#include "validation/contact_output.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

namespace fs = std::filesystem;
using contact_program::Case;
using contact_program::Outcome;
using contact_program::WheelPatch;

constexpr const char* input_folder = MICROSLIP_REFERENCE_DATA "/../contact-cases";
constexpr const char* input_files[] = {"mbench_a22_left",
                                       "mbench_a22_right",
                                       "mbench_a22_varfric",
                                       "mbench_a22_kpec",
                                       "wheel-rail/cases/test-rollers2",
                                       "wheel-rail/cases/m1_steady_roll",
                                       "wheel-rail/cases/t1_zws",
                                       "wheel-rail/cases/t3_t2_force",
                                       "wheel-rail/cases/groove_li",
                                       "wheel-rail/cases/cross_locus",
                                       "wheel-rail/cases/cross_brute",
                                       "wheel-rail/cases/wheelflat"};
/// Files whose last printed digits depend on where CONTACT's searches end, or lie.
struct Remark {
  const char* file;
  const char* reason;
};
constexpr Remark remarks[] = {{"mbench_a22_kpec", "CONTACT ends where the height changes by less than EPS"},
                              {"wheel-rail/cases/cross_locus", "CONTACT ends the search along x at 1e-3 mm"},
                              {"wheel-rail/cases/wheelflat", "they depend on where the search's coarse grid lies"},
                              {"wheel-rail/cases/groove_li", "lateral forces and spin are zero by symmetry"}};
constexpr double relative_difference = 0.01; ///< that counts as near

constexpr double rounding_level = 1e-6; ///< of a quantity's scale: below it is zero but for rounding

/// Ours by CONTACT's names, with what a difference is compared with where the value itself is next to zero.
struct OwnNumber {
  std::string name;
  double value;
  double scale = 0;
};

/// Cases that CONTACT leaves unsolved, and why.
struct Excuse {
  const char* file;
  int number;
  const char* reason;
};
constexpr Excuse excuses[] = {
    {"mbench_a22_kpec", 1, "KPEC's pressure jumps with the height: CONTACT ends with FZ = 9982 N instead of 10000 N"}};

std::vector<OwnNumber> totals_of(const contact_program::WheelOutcome& w) {
  const auto& track = w.track.force;
  const auto& wheelset = w.wheelset.force;
  const double force = 0.1 * std::hypot(track.x, track.y, track.z);
  return {{"Z_WS", w.z},         {"FX(TR)", track.x, force},    {"FY(TR)", track.y, force},
          {"FZ(TR)", track.z},   {"FX(WS)", wheelset.x, force}, {"FY(WS)", wheelset.y, force},
          {"FZ(WS)", wheelset.z}};
}

std::vector<OwnNumber> numbers_of(const WheelPatch& p) {
  const contact_program::PrintedTotals& t = p.solution->totals;
  const contact_program::PatchLocation& l = p.location;
  const double limit = 0.1 * t.fn, size = std::sqrt(t.contact * p.solution->step.grid.element_area()) * 1e3;
  const double creepage = std::max(1e-4, 0.1 * std::hypot(p.contact.x, p.contact.y, size * p.contact.phi));
  const double elements = std::sqrt(std::max(1, t.contact)) / relative_difference;
  return {{"XCP(TR)", l.track.x, 1},
          {"YCP(TR)", l.track.y},
          {"ZCP(TR)", l.track.z, 1},
          {"DELTCP(TR)", l.angle, 0.01},
          {"YCP(R)", l.rail.y, 1},
          {"ZCP(R)", l.rail.z, 1},
          {"XCP(W)", l.wheel.x, 1},
          {"YCP(W)", l.wheel.y, 1},
          {"ZCP(W)", l.wheel.z, 1},
          {"CKSI", p.contact.x, creepage},
          {"CETA", p.contact.y, creepage},
          {"CPHI", p.contact.phi, creepage / std::max(1.0, size)},
          {"FN", t.fn},
          {"FX", t.fx, limit},
          {"FS", t.fy, limit},
          {"MN", t.mz, limit * size},
          {"ELAST.EN.", t.elastic_energy},
          {"FRIC.POWER", t.friction, 1e-6},
          {"FRIC.WORK", t.friction, 1e-6},
          {"FN/G", t.fn_over_g},
          {"BAR_FN", t.fn},
          {"BAR_FX", t.fx, limit},
          {"BAR_FS", t.fy, limit},
          {"TILDE_FN", t.integral_fn.value_or(0)},
          {"FX/FSTAT/FN", t.x, 1},
          {"FS/FSTAT/FN", t.y, 1},
          {"FX/FN", t.x, 1},
          {"FS/FN", t.y, 1},
          {"APPROACH", t.approach},
          {"PMAX", t.peak_pressure},
          {"MAX(T1,T2)", t.temperature.value_or(0)},
          {"NPOT", double(t.potential)},
          {"NCON", double(t.contact), elements},
          {"NADH", double(t.adhesion), elements},
          {"NSLIP", double(t.slip), elements}};
}

/// The cases of a file, one after the other.
class WheelFile {
public:
  WheelFile(Report& report, std::string name)
      : report_(report), name_(std::move(name)),
        printed_(read_contact_output(fs::path(input_folder) / (name_ + ".ref_out"))) {}

  /// False if it was asked to stop.
  bool run(const Progress& progress) {
    const fs::path path = fs::path(input_folder) / (name_ + ".inp");
    std::ifstream in(path);
    if (!in) throw Error(path.string() + ": cannot be read");
    contact_program::InputReader reader(in, path.string());
    contact_program::Run runs;
    report_.heading(fs::path(name_).filename().string() + ".inp");
    const std::clock_t begin = std::clock(); // of the processor, whatever else runs
    while (const Case* c = reader.next()) {
      take(*c, runs.run(*c));
      if (progress && !progress(std::min(1.0, c->number / std::max(1.0, double(printed_.size()))))) return false;
    }
    seconds_ = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    finish();
    return true;
  }

  /// Of the table at the end; empty if there was nothing to compare.
  const std::string& row() const { return row_; }

private:
  void take(const Case& c, const Outcome& o) {
    ++cases_;
    if (o.kind == Outcome::Kind::refused)
      for (const auto& reason : o.reasons) ++refused_[reason];
    if (o.kind != Outcome::Kind::solved || !o.wheel) return;
    ++solved_;
    effort_.geometry += o.wheel->effort.geometry;
    effort_.normal += o.wheel->effort.normal;
    effort_.tangential += o.wheel->effort.tangential;
    const auto printed = printed_.find(c.number);
    if (printed == printed_.end() || is_excused(c.number)) return;
    compare(c.number, "", totals_of(*o.wheel), printed->second.totals);
    const auto& patches = printed->second.patches;
    if (patches.size() != o.wheel->patches.size()) {
      ++other_patches_;
      report_.line(fmt::format("case {}: {} patches, CONTACT {}", c.number, o.wheel->patches.size(), patches.size()));
      return;
    }
    for (std::size_t k = 0; k < patches.size(); ++k)
      compare(c.number, patches.size() > 1 ? fmt::format(" of patch {}", k + 1) : "", numbers_of(o.wheel->patches[k]),
              patches[k]);
  }

  bool is_excused(int number) {
    for (const auto& [file, excused, reason] : excuses)
      if (file == name_ && excused == number) {
        report_.line(fmt::format("case {} is not compared: {}", number, reason));
        return true;
      }
    return false;
  }

  void compare(int number, const std::string& where, const std::vector<OwnNumber>& ours,
               const PrintedNumbers& printed) {
    for (const auto& [name, value, scale] : ours) {
      const auto found = printed.find(name);
      if (found == printed.end()) continue;
      const auto& [theirs, rounding] = found->second;
      const double difference = std::abs(value - theirs);
      ++quantities_;
      const bool is_zero = std::max(std::abs(value), std::abs(theirs)) <= rounding_level * scale;
      const bool equal = difference <= rounding * 1.001 || is_zero;
      equal_ += equal;
      const bool near = difference - rounding <= relative_difference * std::max(std::abs(theirs), scale);
      near_ += near;
      if (!near) report_.line(fmt::format("case {}: {}{} {:.5g}, CONTACT {:.5g}", number, name, where, value, theirs));
      if (!equal && near) ++unequal_[name];
    }
  }

  void finish() {
    for (const auto& [reason, count] : refused_) report_.line(fmt::format("not run: {} cases, {}", count, reason));
    report_.line(fmt::format(
        "{} of {} cases in {:.2f} s of the processor: {} analyses of the geometry, {} normal and {} tangential "
        "problems",
        solved_, cases_, seconds_, effort_.geometry, effort_.normal, effort_.tangential));
    if (quantities_ == 0) return;
    row_ = fmt::format("{:<20} {:>3} {:>5} {:>6} {:>6} {:>7.2f} {:>6} {:>6} {:>6}", fs::path(name_).filename().string(),
                       solved_, effort_.geometry, effort_.normal, effort_.tangential, seconds_, quantities_, equal_,
                       near_);
    std::string names;
    for (const auto& [name, count] : unequal_) names += fmt::format("{}{} {}", names.empty() ? "" : ", ", count, name);
    if (!names.empty()) report_.line("near but not equal: " + names);
    const auto equal = fmt::format("{}", equal_), all = fmt::format("{}", quantities_);
    const auto remark =
        std::find_if(std::begin(remarks), std::end(remarks), [this](const Remark& r) { return name_ == r.file; });
    if (remark != std::end(remarks))
      report_.remark("equal to the printed digits", equal, all, remark->reason);
    else
      report_.figure("equal to the printed digits", equal, all, equal_ >= 0.95 * quantities_);
    report_.figure("within 1 %", fmt::format("{}", near_), fmt::format("{}", quantities_),
                   near_ >= 0.99 * quantities_ && other_patches_ == 0);
  }

  Report& report_;
  std::string name_;
  std::map<int, PrintedCase> printed_;
  std::map<std::string, int> refused_, unequal_;
  contact_program::WheelEffort effort_;
  int cases_ = 0, solved_ = 0, quantities_ = 0, equal_ = 0, near_ = 0, other_patches_ = 0;
  double seconds_ = 0;
  std::string row_;
};

} // namespace

bool run_contact_wheel_rail(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  if (!fs::exists(input_folder)) {
    report.line("SKIPPED: the folder of CONTACT's cases is not beside MICROSLIP_REFERENCE_DATA");
    return true;
  }
  double done = 0;
  std::vector<std::string> rows;
  for (const char* name : input_files) {
    const double end = done + 1.0 / std::size(input_files);
    WheelFile file(report, name);
    if (!file.run(part_of(options.progress, done, end))) return false;
    if (!file.row().empty()) rows.push_back(file.row());
    done = end;
  }
  report.heading("Cases run; geometry analysed, normal and tangential problems solved; seconds of the processor; "
                 "quantities, equal to the "
                 "printed digits, within 1 %");
  report.line(fmt::format("{:<20} {:>3} {:>5} {:>6} {:>6} {:>7} {:>6} {:>6} {:>6}", "", "run", "geo.", "norm.", "tang.",
                          "time s", "all", "equal", "1 %"));
  for (const auto& row : rows) report.line(row);
  return report.all_met();
}

} // namespace microslip::validation
