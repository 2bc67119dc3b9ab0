#include "io/slices_file.hpp"

#include "io/file_beside.hpp"
#include "io/profile_formats.hpp"
#include "io/text_line.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;

constexpr double pi = std::numbers::pi;

std::string whole_number_in(int low, int high) {
  return "must be a whole number in [" + std::to_string(low) + ", " + std::to_string(high) + "]";
}

/// Values separated by blanks, tabs, commas or equals signs; what follows % is a comment. A record's values may stand
/// on several lines; what follows the last one on its line is a remark.
class SliceWords {
public:
  SliceWords(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& text) const {
    throw Error(name_ + ":" + std::to_string(number_) + ": " + text);
  }

  [[noreturn]] void fail(std::string_view field, double value, const std::string& must) const {
    fail(std::string(field) + " = " + digits(value) + ": " + must);
  }

  double real(std::string_view field) {
    const std::string_view word = next(field);
    const auto value = parse_number(word);
    if (!value) fail(std::string(field) + " = " + std::string(word) + ": must be a number");
    return *value;
  }

  int integer(std::string_view field, int low, int high) {
    const double value = real(field);
    if (value != std::floor(value) || value < low || value > high) fail(field, value, whole_number_in(low, high));
    return static_cast<int>(value);
  }

  /// The next value of the line, if it is a whole number.
  int optional_integer(std::string_view field, int otherwise, int low, int high) {
    if (line_.empty()) return otherwise;
    const std::string_view kept = line_;
    const std::string_view word = take();
    const auto value = parse_number(word);
    if (!value) {
      line_ = kept;
      return otherwise;
    }
    if (*value != std::floor(*value) || *value < low || *value > high) fail(field, *value, whole_number_in(low, high));
    return static_cast<int>(*value);
  }

  /// Degrees if it ends in d, else rad.
  double angle(std::string_view field) {
    std::string_view word = next(field);
    const bool degrees = word.ends_with('d');
    if (degrees || word.ends_with('r')) word.remove_suffix(1);
    const auto value = parse_number(word);
    if (!value)
      fail(std::string(field) + " = " + std::string(word) + ": must be an angle, in rad or with d in degrees");
    return *value * (degrees ? pi / 180 : 1);
  }

  /// A text between quotes.
  std::string text(std::string_view field) {
    if (line_.empty() && !next_line()) fail_at_end(field);
    const char quote = line_.front();
    const auto end = quote == '\'' || quote == '"' ? line_.find(quote, 1) : std::string_view::npos;
    if (end == std::string_view::npos) fail(std::string(field) + " must be a file's name between quotes");
    std::string name(line_.substr(1, end - 1));
    if (name.empty()) fail(std::string(field) + " is empty");
    line_ = without_separators(line_.substr(end + 1));
    return name;
  }

  void end_record() { line_ = {}; }

  /// The number of the next line with values, after the end of a record; none at the end of the text.
  std::optional<std::size_t> next_number() { return next_line() ? std::optional(number_) : std::nullopt; }

private:
  static std::string_view without_separators(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t,=\r");
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
  }

  bool next_line() {
    while (line_.empty() && !rest_.empty()) {
      ++number_;
      line_ = without_separators(before_comment(take_line(rest_), "%"));
    }
    return !line_.empty();
  }

  std::string_view take() {
    const auto end = std::min(line_.find_first_of(" \t,=\r"), line_.size());
    const std::string_view word = line_.substr(0, end);
    line_ = without_separators(line_.substr(end));
    return word;
  }

  std::string_view next(std::string_view field) {
    if (line_.empty() && !next_line()) fail_at_end(field);
    return take();
  }

  [[noreturn]] void fail_at_end(std::string_view field) const {
    fail(std::string(field) + " is missing: the file ends here");
  }

  std::string_view rest_, line_;
  std::string name_;
  std::size_t number_ = 0;
};

/// The records of a slices file in their order.
class SlicesReading {
public:
  SlicesReading(std::string_view text, const fs::path& path)
      : words_(text, path.string()), folder_(path.parent_path()) {
    file_.role = lower_case(path.extension().string()) == ".slcw" ? ProfileRole::wheel : ProfileRole::rail;
  }

  SlicesFile file() {
    read_header();
    read_names();
    check_turn();
    read_joints();
    read_features();
    read_waves();
    warn_of_surplus();
    return std::move(file_);
  }

private:
  bool is_wheel() const { return file_.role == ProfileRole::wheel; }
  /// A field's name, which begins with U for rails and with TH for wheels.
  std::string field(const char* ending) const { return (is_wheel() ? "TH" : "U") + std::string(ending); }
  double position(double value) const { return scale_ * (offset_ + value); }

  void read_header() {
    constexpr int most_slices = 4999, most_features = 999;
    offset_ = words_.real(field("_OFFSET"));
    scale_ = words_.real(field("_SCALE"));
    if (!(scale_ > 0)) words_.fail(field("_SCALE"), scale_, "must be positive");
    words_.end_record();
    file_.slices.resize(static_cast<std::size_t>(words_.integer("NSLC", 1, most_slices)));
    words_.end_record();
    features_ = words_.integer("NFEAT", 0, most_features);
    const int most = std::max(0, features_ - 2);
    if (features_ > 1) {
      kinks_ = words_.optional_integer("NKINK", 0, 0, most);
      accelerations_ = words_.optional_integer("NACCEL", 0, 0, most);
    }
    words_.end_record();
    file_.method =
        words_.integer(field("_INTPOL"), 1, 2) == 2 ? SliceMethod::approximating : SliceMethod::interpolating;
    waves_ = words_.optional_integer("PERTURB", 0, 0, 2);
    if (waves_ > 0 && (waves_ == 2) != is_wheel())
      words_.fail("PERTURB", waves_, is_wheel() ? "must be 0 or 2 for a wheel" : "must be 0 or 1 for a rail");
    words_.end_record();
  }

  void read_names() {
    constexpr double least = 1e-3; // mm or rad
    for (std::size_t k = 0; k < file_.slices.size(); ++k) {
      SliceEntry& slice = file_.slices[k];
      slice.u = position(words_.real(field("_SLC")));
      if (k > 0 && !(slice.u - file_.slices[k - 1].u >= least))
        words_.fail(field("_SLC"), slice.u,
                    "must be at least " + digits(least) + " above that of the slice before, " +
                        digits(file_.slices[k - 1].u));
      const std::string name = words_.text(is_wheel() ? "WFNAME" : "RFNAME");
      slice.file = file_beside(folder_, name).string();
      if (names_slices(name))
        words_.fail(std::string(is_wheel() ? "WFNAME" : "RFNAME") + " = " + name + ": must be a profile, not slices");
      words_.end_record();
    }
  }

  /// A wheel's slices lie within a turn, or reach beyond both of its ends.
  void check_turn() const {
    constexpr double slack = 1e-4;
    if (!is_wheel()) return;
    const double first = file_.slices.front().u, last = file_.slices.back().u;
    if (first < -1.5 * pi) words_.fail("TH_SLC", first, "must be in [-1.5 pi, 1.5 pi]");
    if (last > 1.5 * pi) words_.fail("TH_SLC", last, "must be in [-1.5 pi, 1.5 pi]");
    if ((first < -pi - slack && last < pi - slack) || (first > -pi + slack && last > pi + slack))
      words_.fail("TH_SLC", first < -pi - slack ? first : last,
                  "slices must lie within [-pi, pi], or reach to both of its ends");
  }

  std::vector<int> read_parts(const char* name, int count) {
    std::vector<int> parts;
    parts.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) parts.push_back(words_.integer(name, 1, features_ - 2));
    if (count > 0) words_.end_record();
    std::sort(parts.begin(), parts.end());
    return parts;
  }

  /// After part p, from 1, comes feature p, from 0.
  void read_joints() {
    file_.kinks = read_parts("P_KINK", kinks_);
    file_.accelerations = read_parts("P_ACCEL", accelerations_);
  }

  void read_features() {
    if (features_ < 2) return;
    constexpr double tolerance = 1e-3;
    for (SliceEntry& slice : file_.slices) {
      const double u = position(words_.real(field("_SLC")));
      if (!(std::abs(u - slice.u) < tolerance))
        words_.fail(field("_SLC"), u, "must be " + digits(slice.u) + ", as the slices' list has it");
      for (int k = 0; k < features_; ++k) slice.features.push_back(words_.real("S_F"));
      words_.end_record();
    }
  }

  void read_waves() {
    constexpr int most_waves = 1000, highest_order = 100000;
    if (waves_ == 0) return;
    const int count = words_.integer("NTERM", 0, most_waves);
    words_.end_record();
    for (int k = 0; k < count; ++k) {
      ProfileWave wave;
      wave.amplitude = words_.real("AMPL");
      if (is_wheel()) {
        wave.wavenumber = words_.integer("NORDER", 0, highest_order);
        wave.phase = words_.angle("TPHASE");
      } else {
        const double length = words_.real("WAVEL");
        if (!(length > 0)) words_.fail("WAVEL", length, "must be positive");
        wave.wavenumber = 2 * pi / (scale_ * length);
        wave.phase = words_.angle("UPHASE");
      }
      words_.end_record();
      file_.waves.push_back(wave);
    }
  }

  /// The program CONTACT reads no further, either.
  void warn_of_surplus() {
    if (const auto line = words_.next_number())
      file_.warnings.push_back("line " + std::to_string(*line) + " is left out with all that follows: NSLC = " +
                               std::to_string(file_.slices.size()) + ", and nothing belongs to these slices any more");
  }

  SliceWords words_;
  fs::path folder_;
  SlicesFile file_;
  double offset_ = 0, scale_ = 1;
  int features_ = 0, kinks_ = 0, accelerations_ = 0;
  int waves_ = 0; ///< PERTURB
};

} // namespace

bool names_slices(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return ending == ".slcs" || ending == ".slcw";
}

SlicesFile parse_slices(std::string_view text, const fs::path& path) {
  return SlicesReading(text, path).file();
}

SlicesFile read_slices(const fs::path& path) {
  return parse_slices(read_profile_text(path), path);
}

} // namespace microslip::io
