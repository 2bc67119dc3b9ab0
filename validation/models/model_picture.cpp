#include "validation/models/model_picture.hpp"

#include "io/result_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::validation {

void write_model_panels(const std::filesystem::path& file, const std::string& title, const std::string& command_line,
                        const std::vector<ModelPanel>& panels) {
  io::ResultFile out(file, {.kind = "models", .title = title, .command_line = command_line});
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const ModelPanel& panel = panels[k];
    const std::string group = fmt::format("panels/{}/", k + 1);
    std::vector<std::string> names;
    std::vector<double> values;
    for (const ModelPanel::Row& row : panel.rows) {
      names.push_back(row.name);
      values.insert(values.end(), row.values.begin(), row.values.end());
    }
    out.text(group + "title", panel.title, "what the errors are of");
    out.text(group + "series", fmt::format("{}", fmt::join(panel.series, "\n")), "names of the columns, a line each");
    out.text(group + "models", fmt::format("{}", fmt::join(names, "\n")), "names of the rows, a line each");
    out.array(group + "errors", values, "-", "of each model, series by series",
              {panel.rows.size(), panel.series.size()});
  }
  out.commit();
}

} // namespace microslip::validation
