#include "app/validation_report.hpp"

#include "app/child_process.hpp"
#include "app/command_line.hpp"
#include "app/machine.hpp"
#include "io/output_file.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #1d2429; max-width: 62rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; border-top: 1px solid #c8ced2; padding-top: 1rem; margin-top: 2rem; }
table { border-collapse: collapse; width: 100%; margin: .6rem 0; }
th, td { text-align: left; vertical-align: top; padding: .15rem .6rem .15rem 0; border-bottom: 1px solid #e4e8ea; overflow-wrap: break-word; }
thead th { border-bottom: 1px solid #6b757c; }
tr.section th { padding-top: .7rem; font-weight: 600; border: 0; }
td.number { font-variant-numeric: tabular-nums; }
td.number, td.met, td.not, th[scope=row] { white-space: nowrap; }
.met { color: #00613f; } .not { color: #a63d00; font-weight: 700; } .shown { color: #565f65; }
img { max-width: 100%; height: auto; margin: .5rem 0; }
pre { overflow-x: auto; font-size: .8rem; background: #f5f6f6; padding: .6rem; }
@media print { body { max-width: none; margin: 0; } details { display: none; } tr, img { break-inside: avoid; } h2 { break-after: avoid; } }
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) switch (letter) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += letter;
    }
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string picture(const fs::path& file) {
  const std::string name = escaped(file.stem().string());
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n", name, base64(contents(file)));
}

std::string verdict(const validation::Figure& figure) {
  if (!figure.met) return fmt::format("<td class=\"shown\">{}</td>", escaped(figure.remark));
  if (figure.is_known) return fmt::format("<td class=\"not\">NOT MET, {}</td>", escaped(figure.remark));
  return *figure.met ? "<td class=\"met\">met</td>" : "<td class=\"not\">NOT MET</td>";
}

std::string figures_table(const std::vector<validation::Figure>& figures) {
  std::string rows, section;
  for (const auto& figure : figures) {
    if (figure.section != section) {
      section = figure.section;
      rows +=
          fmt::format("<tr class=\"section\"><th colspan=\"4\" scope=\"colgroup\">{}</th></tr>\n", escaped(section));
    }
    rows += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>{}</tr>\n",
                        escaped(figure.name), escaped(figure.computed), escaped(figure.expected), verdict(figure));
  }
  return "<table><thead><tr><th scope=\"col\">figure</th><th scope=\"col\">computed</th><th scope=\"col\">published or "
         "expected</th><th scope=\"col\"></th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

/// With a capital and a full stop.
std::string sentence(std::string words) {
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words + ".";
}

std::string study_section(const StudyRecord& record) {
  std::string out = fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p>{1}</p>\n<p class=\"{2}\">{3} ({4:.1f} s)</p>\n",
                                record.study->name, escaped(record.study->summary), record.as_stated ? "met" : "not",
                                sentence(outcome(record.as_stated, record.figures)), record.seconds);
  if (!record.figures.empty()) out += figures_table(record.figures);
  for (const auto& file : record.pictures) out += picture(file);
  return out +
         fmt::format("<details><summary>as it is printed</summary><pre>{}</pre></details>\n", escaped(record.text));
}

std::string fact(std::string_view name, std::string_view value) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", name, escaped(value));
}

std::string facts(const std::vector<StudyRecord>& records) {
  const BuildInfo build = build_info();
  double seconds = 0;
  for (const auto& record : records) seconds += record.seconds;
  return "<table><tbody>\n" + fact("program", fmt::format("microslip {}, commit {}", build.version, build.commit)) +
         fact("compiler", fmt::format("{}, {}", build.compiler, build.build_type)) + fact("machine", machine()) +
         fact("time", fmt::format("{:%Y-%m-%d %H:%M:%S} UTC, {:.0f} s", fmt::gmtime(std::time(nullptr)), seconds)) +
         fact("command", command_line()) + "</tbody></table>\n";
}

std::string index(const std::vector<StudyRecord>& records) {
  std::string rows;
  for (const auto& [study, as_stated, seconds, figures, text, pictures] : records) {
    const auto judged = std::ranges::count_if(figures, [](const auto& figure) { return figure.met.has_value(); });
    const auto good = std::ranges::count_if(figures, [](const auto& figure) { return figure.met.value_or(false); });
    rows += fmt::format(
        "<tr><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td>{2} of {3}</td><td class=\"{4}\">{5}</td></tr>\n",
        study->name, escaped(study->summary), good, judged, as_stated ? "met" : "not",
        as_stated ? "as stated" : "NOT as stated");
  }
  return "<table><thead><tr><th scope=\"col\">study</th><th scope=\"col\">what it shows</th><th "
         "scope=\"col\">figures</th><th scope=\"col\"></th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

std::string page(const std::vector<StudyRecord>& records) {
  const bool all = std::ranges::all_of(records, &StudyRecord::as_stated);
  std::string sections;
  std::vector<validation::Figure> figures;
  for (const auto& record : records) {
    sections += study_section(record);
    figures.insert(figures.end(), record.figures.begin(), record.figures.end());
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>microslip: validation report</title><style>{}</style></head><body>\n"
      "<h1>microslip: validation report</h1>\n<p>Computed figures beside those that are published, or that follow from "
      "closed formulas. <span class=\"{}\">{}</span></p>\n<p>What each figure must keep to is written in the study "
      "before it runs, and stands beside the figure; figures without a verdict are shown for comparison only. A figure "
      "that is not met for a reason that the documentation gives is a known limit: the report names it, the limit that "
      "it keeps to, and the page.</p>\n{}{}{}</body></html>\n",
      style, all ? "met" : "not", sentence(outcome(all, figures)), facts(records), index(records), sections);
}

/// Returns whether a browser has made it.
bool print_to(const fs::path& pdf, const fs::path& html) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::tmpfile(), std::fclose);
  if (!nowhere) return false;
  for (const char* browser : {"chromium", "chromium-browser", "google-chrome"}) {
    io::OutputFile file(pdf);
    const int code =
        run_child({browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
                   "--print-to-pdf=" + fs::absolute(file.temporary()).string(), fs::absolute(html).string()},
                  environment_variables(), nowhere.get(), nowhere.get());
    std::error_code unknown;
    if (code != 0 || fs::file_size(file.temporary(), unknown) == 0 || unknown) continue;
    file.commit();
    return true;
  }
  return false;
}

} // namespace

std::string outcome(bool as_stated, const std::vector<validation::Figure>& figures) {
  if (!as_stated) return "NOT all figures are as stated";
  const auto known = std::ranges::count_if(figures, &validation::Figure::is_known);
  if (known == 0) return "all figures are met";
  return fmt::format("all figures are as stated, {} of {} {} a known limit", known, figures.size(),
                     known == 1 ? "is" : "are");
}

std::vector<std::string> write_validation_report(const fs::path& folder, const std::vector<StudyRecord>& records) {
  const fs::path html = folder / validation_page, pdf = folder / "validation.pdf";
  io::OutputFile file(html);
  file.write(page(records));
  file.commit();
  std::vector<std::string> written = {html.string()};
  if (print_to(pdf, html)) written.push_back(pdf.string());
  return written;
}

} // namespace microslip::app
