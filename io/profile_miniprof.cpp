#include "io/nearest_word.hpp"
#include "io/profile_formats.hpp"
#include "io/text_line.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

namespace microslip::io {
namespace {

/// Columns of numbers that are y and z.
struct Columns {
  std::size_t y = 0, z = 1;
};

class MiniprofReader {
public:
  MiniprofReader(ProfileLines lines, int section) : lines_(std::move(lines)), section_(section) {}

  ProfileFile read() {
    while (lines_.next()) read_line(lines_.line());
    check_sections();
    if (rows_.empty()) lines_.fail_as_a_whole("there are no points");
    file_.points_read = rows_.size();
    describe();
    take_points();
    return std::move(file_);
  }

private:
  struct Row {
    std::vector<double> numbers;
    ProfileLines at; ///< for messages
  };

  void read_line(std::string_view line) {
    ++line_number_;
    if (line_number_ == 1) is_old_ = lower_case(line).find("mini") != std::string::npos && !is_key(line);
    if (line_number_ == 1 && is_old_) note_role(lower_case(line));
    if (line.empty()) {
      has_header_ended_ = true;
    } else if (line.starts_with('[')) {
      begin_section(line);
    } else if (is_key(line)) {
      read_key(line);
    } else if (line.starts_with('"') || line.starts_with('!') || line.starts_with('%') || line.starts_with('#')) {
      if (has_points()) ++commented_out_;
    } else {
      read_data(line);
    }
  }

  /// An = that stands neither in a comment nor in a remark behind numbers.
  static bool is_key(std::string_view line) {
    const auto sign = line.find('=');
    if (sign == std::string_view::npos || sign == 0 || line.find_first_of("!%") < sign) return false;
    const auto words = split(line.substr(0, sign), ",;");
    return words.size() < 2 || !parse_number(words[0]) || !parse_number(words[1]);
  }

  bool has_points() const { return !rows_.empty(); }

  void begin_section(std::string_view line) {
    section_name_ = std::string(line.substr(1, line.find(']') - 1));
    if (!section_name_.ends_with("Points")) return;
    ++sections_;
    if (sections_ == section_) wanted_ = section_name_.substr(0, section_name_.size() - 6);
  }

  void read_key(std::string_view line) {
    line = unquoted(line);
    const auto sign = line.find('=');
    keys_[section_name_ + "/" + lower_case(trimmed(unquoted(trimmed(line.substr(0, sign)))))] =
        std::string(unquoted(trimmed(line.substr(sign + 1))));
  }

  /// Reads the numbers. In an old file they begin after the blank line, in newer ones where the keys end. Other words
  /// are free text, and so is all after a number for each of the columns.
  void read_data(std::string_view line) {
    const bool is_mpt = !section_name_.empty();
    if (is_mpt && (!section_name_.ends_with("Points") || sections_ != section_)) return;
    if (is_old_ && !has_header_ended_) return;
    const auto fields = split(before_comment(line, "\"!%"), ",;");
    if (!has_points() && (fields.size() < 2 || !parse_number(fields[0]))) {
      if (is_old_ || !has_header_ended_) return;
      lines_.fail(printable(line) + " is not a row of numbers");
    }
    if (!has_points()) columns_named_ = std::max<std::size_t>(2, column_names().size());
    Row row{{}, lines_};
    for (const auto field : fields) {
      const bool is_remark = row.numbers.size() >= columns_named_ && !parse_number(field);
      remarks_ += is_remark;
      if (is_remark) break;
      row.numbers.push_back(lines_.number(field, "a coordinate"));
    }
    rows_.push_back(std::move(row));
  }

  void check_sections() {
    if (sections_ == 0 && section_ != 1)
      lines_.fail_as_a_whole("section " + std::to_string(section_) + " is asked for, but the file has no sections");
    if (sections_ > 0 && (section_ < 1 || section_ > sections_))
      lines_.fail_as_a_whole("section " + std::to_string(section_) + " is asked for: there are " +
                             std::to_string(sections_));
    if (sections_ > 1)
      file_.assumptions.push_back("profile " + std::to_string(section_) + " of " + std::to_string(sections_) +
                                  " in the file");
  }

  /// A key of the wanted profile, else of the file.
  std::optional<std::string> key(const std::string& name) const {
    for (const auto& section : {wanted_ + "Info", wanted_ + "Points", std::string("FileInfo"), std::string()})
      if (const auto found = keys_.find(std::string(section).append("/").append(name)); found != keys_.end())
        return found->second;
    return {};
  }

  double offset(const std::string& name) const {
    const auto text = key(name);
    if (!text || text->empty()) return 0;
    const auto value = parse_number(*text);
    if (!value) lines_.fail_as_a_whole(name + " = " + printable(*text) + " is not a number");
    return *value;
  }

  void note_role(const std::string& words) {
    if (words.find("wheel") != std::string::npos) file_.role = ProfileRole::wheel;
    if (words.find("rail") != std::string::npos) file_.role = ProfileRole::rail;
  }

  void describe() {
    file_.unit = 1e-3;
    file_.comment = key("comment").value_or("");
    for (const auto* name : {"railgaugepoint", "railalignment", "rail"})
      if (key(name)) file_.role = ProfileRole::rail;
    for (const auto* name : {"wheeladjustpoint", "wheeldiametertaperline", "sd", "sh", "qr"})
      if (key(name)) file_.role = ProfileRole::wheel;
    if (const auto points = key("xypoints"); points && !points->empty()) {
      const auto count = parse_number(*points);
      const auto listed = static_cast<double>(rows_.size() + commented_out_);
      if (count && *count != listed)
        file_.warnings.push_back("XYPoints = " + *points + ", but there are " + digits(listed) + "; is it truncated?");
    }
    if (commented_out_ > 0)
      file_.steps.push_back("left out " + counted(commented_out_, "line") + " of points marked as comments");
    if (remarks_ > 0) file_.steps.push_back("left out the text behind the numbers of " + counted(remarks_, "line"));
  }

  std::vector<std::string> column_names() const {
    std::vector<std::string> names;
    const std::string text = key("columndef").value_or("");
    for (const auto name : split(text, ",;")) names.push_back(lower_case(name));
    return names;
  }

  Columns columns() const {
    const auto names = column_names();
    if (names.empty()) return {};
    const auto place = [&](std::string_view name) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        lines_.fail_as_a_whole("ColumnDef = " + printable(*key("columndef")) + " has no X or no Y");
      return static_cast<std::size_t>(found - names.begin());
    };
    return {place("x"), place("y")};
  }

  void take_points() {
    const auto [y, z] = columns();
    const double y_offset = offset("xoffset"), z_offset = offset("yoffset");
    for (const auto& row : rows_) {
      if (row.numbers.size() <= std::max(y, z))
        row.at.fail(counted(row.numbers.size(), "number") + ", but column " + std::to_string(std::max(y, z) + 1) +
                    " is needed");
      file_.points.push_back({row.numbers[y] + y_offset, row.numbers[z] + z_offset});
    }
    if (y_offset != 0 || z_offset != 0)
      file_.steps.push_back("shifted by (" + digits(y_offset) + ", " + digits(z_offset) + ") mm");
  }

  ProfileLines lines_;
  ProfileFile file_;
  std::vector<Row> rows_;
  std::map<std::string, std::string> keys_; ///< by section and name in lower case
  std::string section_name_, wanted_;
  int section_, sections_ = 0;
  std::size_t line_number_ = 0, commented_out_ = 0, remarks_ = 0;
  std::size_t columns_named_ = 2; ///< that a row has numbers for
  bool is_old_ = false, has_header_ended_ = false;
};

} // namespace

ProfileFile parse_miniprof(ProfileLines lines, int section) {
  return MiniprofReader(std::move(lines), section).read();
}

} // namespace microslip::io
