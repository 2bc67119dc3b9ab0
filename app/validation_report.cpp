#include "app/validation_report.hpp"

#include "app/child_process.hpp"
#include "app/command_line.hpp"
#include "app/machine.hpp"
#include "io/output_file.hpp"
#include "io/sha256.hpp"
#include "microslip/version.hpp"
#include "validation/clauses.hpp"

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
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h3 { font-size: 1rem; margin: 1.2rem 0 .2rem; }
h2 { font-size: 1.2rem; border-top: 1px solid #c8ced2; padding-top: 1rem; margin-top: 2rem; }
table { border-collapse: collapse; width: 100%; margin: .6rem 0; }
th, td { text-align: left; vertical-align: top; padding: .15rem .6rem .15rem 0; border-bottom: 1px solid #e4e8ea; overflow-wrap: break-word; }
thead th { border-bottom: 1px solid #6b757c; }
tr.section th { padding-top: .7rem; font-weight: 600; border: 0; }
td.number { font-variant-numeric: tabular-nums; }
td.number, td.met, td.not, th[scope=row] { white-space: nowrap; }
.clauses { table-layout: fixed; } .clauses td:nth-child(3), .clauses td:nth-child(4) { white-space: nowrap; }
.clauses th:nth-child(1) { width: 13%; } .clauses th:nth-child(3) { width: 17%; } .clauses th:nth-child(4) { width: 11%; } .clauses th:nth-child(5) { width: 14%; }
.digest { font-family: monospace; font-size: .8rem; overflow-wrap: anywhere; }
.met { color: #00613f; } .limit { color: #6b4d00; } .not { color: #a63d00; font-weight: 700; } .shown { color: #565f65; }
.outcome { border: 2px solid; padding: .5rem .8rem; font-size: 1.1rem; font-weight: 600; }
.signatures td { height: 3.2rem; border: 1px solid #6b757c; padding: .3rem .5rem; width: 22%; }
.signatures th { border: 1px solid #6b757c; padding: .3rem .5rem; }
img { max-width: 100%; height: auto; margin: .5rem 0; }
pre { overflow-x: auto; font-size: .8rem; background: #f5f6f6; padding: .6rem; }
@media print {
  body { max-width: none; margin: 0; padding: 0; font-size: 9.5pt; } a { color: inherit; text-decoration: none; }
  details { display: none; } tr, img, .signatures { break-inside: avoid; } h2, h3, h2 + p, h3 + p { break-after: avoid; } .results { break-before: page; }
}
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
  std::string out = fmt::format("<h3 id=\"{0}\">{0}</h3>\n<p>{1}</p>\n<p class=\"{2}\">{3} ({4:.1f} s)</p>\n",
                                record.study->name, escaped(record.study->summary), record.as_stated ? "met" : "not",
                                sentence(outcome(record.as_stated, record.figures)), record.seconds);
  if (!record.figures.empty()) out += figures_table(record.figures);
  for (const auto& file : record.pictures) out += picture(file);
  return out +
         fmt::format("<details><summary>as it is printed</summary><pre>{}</pre></details>\n", escaped(record.text));
}

std::string fact(std::string_view name, std::string_view value, std::string_view kind = "") {
  return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"{}\">{}</td></tr>\n", name, kind, escaped(value));
}

std::string time_text(std::time_t time) {
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(time));
}

std::string figures_digest(const std::vector<StudyRecord>& records) {
  std::string lines;
  for (const auto& record : records) lines += validation::signed_lines(record.study->name, record.figures);
  return io::sha256(lines);
}

std::string identification(const ReportHead& head, const std::vector<StudyRecord>& records) {
  const BuildInfo build = build_info();
  double seconds = 0;
  for (const auto& record : records) seconds += record.seconds;
  std::string rows = fact("program", fmt::format("microslip {}, commit {}", build.version, build.commit));
  if (build.commit.ends_with("-dirty") || build.commit == "unknown")
    rows += fact("sources", "not those of a commit: nobody can build this program again", "not");
  rows += fact("compiler", fmt::format("{}, {}", build.compiler, build.build_type)) + fact("machine", machine());
  rows += fact("begun", time_text(head.begin)) + fact("time taken", fmt::format("{:.0f} s", seconds));
  rows += fact("command", command_line(), "digest");
  for (const auto& [file, sha256] : head.programs)
    rows += fact(fmt::format("SHA-256 of {}", file.filename().string()), sha256, "digest");
  rows += fact("SHA-256 of the figures", figures_digest(records), "digest");
  return "<h2>2. Identification</h2>\n<table><tbody>\n" + rows + "</tbody></table>\n";
}

struct Words {
  const char *kind, *text;
};

Words words_of(validation::Verdict verdict) {
  switch (verdict) {
  case validation::Verdict::passed:
    return {"met", "pass"};
  case validation::Verdict::passed_with_known_limits:
    return {"limit", "pass with known limits"};
  case validation::Verdict::failed:
    return {"not", "FAIL"};
  case validation::Verdict::only_shown:
    return {"shown", "shown, not judged"};
  case validation::Verdict::not_examined:
    break;
  }
  return {"shown", "not examined"};
}

const std::vector<validation::Figure>* figures_of(std::string_view study, const std::vector<StudyRecord>& records) {
  const auto found = std::ranges::find_if(records, [&](const auto& record) { return record.study->name == study; });
  return found == records.end() ? nullptr : &found->figures;
}

std::string clause_row(const validation::Clause& clause, const std::vector<StudyRecord>& records) {
  const auto* figures = figures_of(clause.study, records);
  const auto result = judge(clause, figures ? *figures : std::vector<validation::Figure>());
  const auto [kind, text] = words_of(result.verdict);
  std::string what = escaped(clause.text);
  if (!clause.note.empty()) what += fmt::format("<br><span class=\"shown\">{}</span>", escaped(clause.note));
  const std::string evidence = figures ? fmt::format("<a href=\"#{0}\">{0}</a>", clause.study) : "";
  const std::string count = result.judged > 0 ? fmt::format("{} of {}", result.met, result.judged) : "";
  return fmt::format("<tr><td class=\"clause\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n",
                     clause.number, what, evidence, count, kind, text);
}

std::string clauses(const std::vector<StudyRecord>& records) {
  std::string out =
      "<h2>4. Clauses</h2>\n<p>Each clause is judged by all figures of the study that is named, or of the part of it "
      "that "
      "concerns the clause. A clause whose study was not run, or lacked its data, is not examined: this report says "
      "nothing of it.</p>\n";
  for (const auto& group : validation::clause_groups()) {
    out += fmt::format("<h3>{}</h3>\n<p>{}</p>\n<table class=\"clauses\"><thead><tr><th scope=\"col\">clause</th><th "
                       "scope=\"col\">what is stated</th><th scope=\"col\">study</th><th scope=\"col\">figures "
                       "met</th><th scope=\"col\">verdict</th></tr></thead><tbody>\n",
                       group.title, escaped(group.source));
    for (const auto& clause : group.clauses) out += clause_row(clause, records);
    out += "</tbody></table>\n";
  }
  return out;
}

std::string known_limits(const std::vector<StudyRecord>& records) {
  std::string rows;
  for (const auto& record : records)
    for (const auto& figure : record.figures)
      if (figure.is_known)
        rows += fmt::format("<tr><td>{}</td><td>{}, {}</td><td>{}</td><td>{}</td><td class=\"limit\">{}</td></tr>\n",
                            record.study->name, escaped(figure.section), escaped(figure.name), escaped(figure.computed),
                            escaped(figure.expected), escaped(figure.remark));
  const std::string heading = "<h2>5. Known limits</h2>\n";
  if (rows.empty()) return heading + "<p>No figure misses its mark for a reason that the documentation gives.</p>\n";
  return heading +
         "<p>These figures miss their mark for a reason that the named page of the documentation gives, and keep to "
         "the "
         "limit that is stated there.</p>\n<table><thead><tr><th scope=\"col\">study</th><th "
         "scope=\"col\">figure</th><th scope=\"col\">computed</th><th scope=\"col\">demanded</th><th "
         "scope=\"col\">limit, page</th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

std::string signatures(const std::vector<StudyRecord>& records) {
  std::string rows;
  for (const char* role : {"Computed by", "Checked by", "Approved by"})
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td></td><td></td><td></td><td></td></tr>\n", role);
  return fmt::format(
      "<h2>6. Signatures</h2>\n<p>Signed for the figures with the SHA-256 <span "
      "class=\"digest\">{}</span>:</p>\n<table "
      "class=\"signatures\"><thead><tr><th></th><th scope=\"col\">name</th><th scope=\"col\">organisation</th><th "
      "scope=\"col\">date</th><th scope=\"col\">signature</th></tr></thead><tbody>\n{}</tbody></table>\n",
      figures_digest(records), rows);
}

/// A common folder is said once.
std::string inputs_annex(const ReportHead& head) {
  std::string rows;
  fs::path folder;
  for (const auto& [file, sha256] : head.inputs) {
    if (file.parent_path() != folder) {
      folder = file.parent_path();
      rows += fmt::format("<tr class=\"section\"><th colspan=\"2\" scope=\"colgroup\">{}</th></tr>\n",
                          escaped(folder.string()));
    }
    rows += fact(escaped(file.filename().string()), sha256, "digest");
  }
  const std::string heading = "<h2>Annex: published results and cases that were at hand</h2>\n";
  if (rows.empty()) return heading + "<p>None: studies used only what is in the program.</p>\n";
  return heading + "<p>With their SHA-256.</p>\n<table><tbody>\n" + rows + "</tbody></table>\n";
}

std::string purpose_text(const ReportHead& head) {
  return "<h2>1. Purpose</h2>\n<p>To show that this build of microslip, on this machine, computes what is published "
         "and "
         "what follows from closed forms, within stated tolerances. It holds for the programs whose digests stand "
         "below; "
         "<span class=\"digest\">microslip</span> and the programs and libraries built with it compute by the same "
         "code.</p>\n" +
         (head.purpose.empty() ? "" : fmt::format("<p>{}</p>\n", escaped(head.purpose)));
}

constexpr const char* method = R"(<h2>3. Method and tolerances</h2>
<p>A study computes figures and prints each beside the published one, or beside the bound that it must keep to. What a
figure must keep to is a constant of the program, so it is fixed before the run and cannot follow the result; it stands
beside the figure in section 7. A figure is <b>met</b> or <b>NOT MET</b>. One that is not met for a reason that the
documentation gives, and keeps to the limit stated there, is a <b>known limit</b>. Figures without a verdict are shown for
comparison only. Ratios of times are judged, but differ from run to run and are no part of the digest of the figures. The
command above, given to the same program on the same files, repeats the report and this digest.</p>
)";

/// At the foot of every printed page, so that none can be exchanged.
std::string page_style(const std::vector<StudyRecord>& records) {
  return fmt::format(
      "@page {{ size: A4; margin: 18mm 16mm 20mm 18mm; @bottom-left {{ font: 8pt sans-serif; content: "
      "\"microslip {}, figures {}\"; }} @bottom-right {{ font: 8pt sans-serif; content: counter(page) \" "
      "of \" counter(pages); }} }}\n",
      build_info().version, figures_digest(records).substr(0, 16));
}

std::string page(const ReportHead& head, const std::vector<StudyRecord>& records) {
  const bool all = std::ranges::all_of(records, &StudyRecord::as_stated);
  std::string sections;
  std::vector<validation::Figure> figures;
  for (const auto& record : records) {
    sections += study_section(record);
    figures.insert(figures.end(), record.figures.begin(), record.figures.end());
  }
  const auto judged = std::ranges::count_if(figures, [](const auto& figure) { return figure.met.has_value(); });
  const std::string first =
      fmt::format("<h1>Validation report</h1>\n<p>microslip {}: computed figures beside those that are published, or "
                  "that follow from "
                  "closed formulas.</p>\n<p class=\"outcome {}\">{} Studies run: {} of {}; figures judged: {}.</p>\n",
                  build_info().version, all ? "met" : "not", sentence(outcome(all, figures)), records.size(),
                  validation::studies().size(), judged);
  return fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<title>microslip: validation report</title><style>{}{}</style></head><body>\n{}{}{}{}{}{}{}<h2 "
                     "class=\"results\">7. Figures</h2>\n{}{}</body></html>\n",
                     style, page_style(records), first, purpose_text(head), identification(head, records), method,
                     clauses(records), known_limits(records), signatures(records), sections, inputs_annex(head));
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

std::vector<DigestedFile> digested(const std::vector<fs::path>& files) {
  std::vector<DigestedFile> out;
  for (const fs::path& file : files) out.push_back({file, io::sha256_of_file(file)});
  return out;
}

std::vector<std::string> write_validation_report(const fs::path& folder, const ReportHead& head,
                                                 const std::vector<StudyRecord>& records) {
  const fs::path html = folder / validation_page, pdf = folder / "validation.pdf";
  io::OutputFile file(html);
  file.write(page(head, records));
  file.commit();
  std::vector<std::string> written = {html.string()};
  if (print_to(pdf, html)) written.push_back(pdf.string());
  return written;
}

} // namespace microslip::app
