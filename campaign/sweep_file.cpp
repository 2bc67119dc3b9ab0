#include "campaign/sweep_file.hpp"

#include "io/result_attribute.hpp"
#include "io/result_file.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"
#include "microslip/status.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>
#include <string>

namespace microslip::campaign {
namespace {

constexpr std::size_t block = 4096; ///< cases that are written at a time
constexpr const char *identity_name = "sweep_identity", *failed_name = "sweep_failed"; ///< attributes
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A column that comes into being with its first number: what no case has, the file leaves out.
class ColumnWriter {
public:
  ColumnWriter(io::ResultFile& file, SweepColumn column)
      : file_(file), column_(std::move(column)), is_status_(column_.path.ends_with("status")) {}

  void add(double value) { values_.push_back(value); }

  void flush() {
    if (is_status_)
      write_status();
    else
      write_numbers();
    values_.clear();
  }

private:
  void write_numbers() {
    const bool is_given = std::any_of(values_.begin(), values_.end(), [](double v) { return !std::isnan(v); });
    if (!is_given && !is_begun_) {
      missing_ += values_.size();
      return;
    }
    for (; missing_ > 0; missing_ -= std::min(missing_, block))
      write(std::vector<double>(std::min(missing_, block), nan));
    is_begun_ = true;
    write(values_);
  }
  void write(const std::vector<double>& values) {
    file_.append(column_.path, values, column_.unit, column_.description);
  }

  /// A case that could not be read has no row.
  void write_status() {
    std::vector<std::uint8_t> codes;
    for (const double value : values_)
      codes.push_back(std::isnan(value) ? static_cast<std::uint8_t>(Status::invalid_input)
                                        : static_cast<std::uint8_t>(value));
    file_.append(column_.path, codes, column_.unit, column_.description);
  }

  io::ResultFile& file_;
  SweepColumn column_;
  bool is_status_, is_begun_ = false;
  std::size_t missing_ = 0; ///< cases before the first number
  std::vector<double> values_;
};

class SweepWriter {
public:
  SweepWriter(const Sweep& sweep, io::ResultFile& file) : spec_(sweep.spec()), file_(file) {
    for (const SweepColumn& column : sweep.columns()) columns_.emplace_back(file, column);
  }

  void add(const CampaignRows& rows) {
    for (std::size_t k = 0; k < rows.values.size(); ++k) columns_[k % columns_.size()].add(rows.values[k]);
    for (std::size_t k = 1; k < rows.values.size(); k += columns_.size()) count_warnings(rows.values[k]);
    end_ += rows.values.size() / columns_.size();
    for (const auto& [index, reason] : rows.failed) {
      failed_.push_back(static_cast<int>(index));
      reasons_.push_back(reason);
    }
    if (end_ - begin_ >= block) flush();
  }

  SweepCount finish() {
    flush();
    if (!spec_.shape().empty()) {
      const std::vector<int> shape(spec_.shape().begin(), spec_.shape().end());
      file_.array("shape", shape, "-", "values of each parameter of the grid, the last one varies fastest");
    }
    std::string names;
    for (const SweepParameter& p : spec_.parameters()) names.append(names.empty() ? "" : "\n").append(p.name);
    file_.attribute("/", "parameters", names);
    return {end_, failures_, warnings()};
  }

private:
  void count_warnings(double code) {
    if (std::isnan(code)) return;
    const Warnings warnings{static_cast<std::uint32_t>(code)};
    for (const WarningInfo& one : warning_table())
      warned_[static_cast<std::size_t>(one.warning)] += warnings.has(one.warning);
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> lines;
    for (const WarningInfo& one : warning_table())
      if (const std::size_t cases = warned_[static_cast<std::size_t>(one.warning)]; cases > 0)
        lines.push_back(std::string(one.text) + " (" + std::to_string(cases) + " of " + std::to_string(end_) +
                        " cases)");
    return lines;
  }

  void flush() {
    write_parameters();
    for (ColumnWriter& column : columns_) column.flush();
    file_.append("failures/case", std::span<const int>(failed_), "-", "cases whose status is not ok, from 0");
    file_.append("failures/reason", reasons_, "why");
    failures_ += failed_.size();
    failed_.clear();
    reasons_.clear();
    begin_ = end_;
  }

  void write_parameters() {
    for (std::size_t k = 0; k < spec_.parameters().size(); ++k) {
      const SweepParameter& parameter = spec_.parameters()[k];
      const std::string path = "parameters/" + parameter.name, description = "key of the case file";
      std::vector<double> numbers;
      std::vector<std::string> texts;
      for (std::size_t i = begin_; i < end_; ++i)
        if (parameter.is_number)
          numbers.push_back(number_of(spec_.value(i, k)));
        else
          texts.push_back(spec_.text_of(i, k));
      if (parameter.is_number)
        file_.append(path, numbers, parameter.unit, description);
      else
        file_.append(path, texts, description);
    }
  }
  static double number_of(const CaseValue& value) {
    return value.node == nullptr ? value.number : value.node->value_or(nan);
  }

  const SweepSpec& spec_;
  io::ResultFile& file_;
  std::vector<ColumnWriter> columns_;
  std::size_t begin_ = 0, end_ = 0, failures_ = 0;
  std::array<std::size_t, warning_count> warned_{};
  std::vector<int> failed_;
  std::vector<std::string> reasons_;
};

} // namespace

std::filesystem::path checkpoint_of(const std::filesystem::path& output) {
  return output.string() + ".checkpoint";
}

SweepCount write_sweep(const Sweep& sweep, const Campaign& campaign, const io::Provenance& provenance,
                       const std::filesystem::path& path, const Progress& progress) {
  io::ResultFile file(path, provenance, io::ResultFile::Storage::disk);
  SweepWriter writer(sweep, file);
  campaign.read([&](const CampaignRows& rows) {
    go_on(progress, static_cast<double>(rows.number) / static_cast<double>(campaign.plan().chunks()));
    writer.add(rows);
  });
  SweepCount count = writer.finish();
  file.attribute("/", "case", sweep.spec().base_name());
  if (!sweep.spec().base_text().empty()) file.attribute("/", "base_case_text", sweep.spec().base_text());
  if (const auto& sample = sweep.spec().sample())
    file.attribute("/", sample_aim_name,
                   std::string(description::sample_aims[static_cast<std::size_t>(sample->aim())]));
  file.attribute("/", identity_name, std::to_string(campaign.plan().identity));
  file.attribute("/", failed_name, std::to_string(count.failed));
  std::string warnings;
  for (const std::string& line : count.warnings) warnings.append(warnings.empty() ? "" : "\n").append(line);
  if (!warnings.empty()) file.attribute("/", "warnings", warnings);
  file.commit();
  return count;
}

std::optional<SweepCount> find_sweep(const Sweep& sweep, const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const auto identity = io::result_attribute(path, identity_name), failed = io::result_attribute(path, failed_name);
  if (identity != std::to_string(sweep.spec().identity()) || !failed)
    throw Error(path.string() + ": is there already, and is no result of this sweep: its specification, files or build "
                                "are others; remove it, or name another file");
  SweepCount count{sweep.spec().count(), static_cast<std::size_t>(std::stoull(*failed))};
  std::istringstream warnings(io::result_attribute(path, "warnings").value_or(""));
  for (std::string line; std::getline(warnings, line);) count.warnings.push_back(line);
  return count;
}

} // namespace microslip::campaign
