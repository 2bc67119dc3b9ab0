#include "cases/inputs.hpp"

#include <algorithm>
#include <string>

namespace microslip::cases {
namespace {

/// Writes a value under its path.
class Write {
public:
  Write(io::ResultWriter& file, std::string path, const description::Input& input)
      : file_(file), path_(std::move(path)), unit_(input.unit.empty() ? "-" : input.unit), text_(input.text) {}

  void operator()(double value) const { file_.scalar(path_, value, unit_, text_); }
  void operator()(const std::string& value) const { file_.text(path_, value, text_); }
  void operator()(const std::vector<double>& values) const { file_.array(path_, values, unit_, text_); }
  void operator()(const std::vector<std::string>&) const {} // no input is one

private:
  io::ResultWriter& file_;
  std::string path_, unit_, text_;
};

} // namespace

void write_inputs(io::ResultWriter& file, const io::ReadInputs& inputs, const description::InputTable& table) {
  for (const auto& [path, read] : inputs) {
    const std::size_t end = path.rfind('.'); // of the section's name
    const bool has_section = end != std::string::npos;
    const description::Input* input =
        table.find(has_section ? path.substr(0, end) : "", path.substr(has_section ? end + 1 : 0));
    if (input == nullptr || (input->is_state && !read.is_given) || path == "title") continue;
    std::string dataset = "inputs/" + path;
    std::replace(dataset.begin(), dataset.end(), '.', '/');
    std::visit(Write(file, dataset, *input), read.value);
  }
}

} // namespace microslip::cases
