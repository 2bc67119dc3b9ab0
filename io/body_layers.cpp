#include "io/body_layers.hpp"

#include "io/toml_section.hpp"
#include "microslip/elasticity/shore_hardness.hpp"
#include "microslip/error.hpp"

#include <string>
#include <string_view>

namespace microslip::io {
namespace {

/// Shares of a modulus that relax, and their times; none without either.
PronySeries read_relaxation(const TomlSection& layer, std::string_view shares_key, std::string_view times_key) {
  if (!layer.has(shares_key) && !layer.has(times_key)) return {};
  const std::vector<double> shares = layer.numbers(shares_key), times = layer.numbers(times_key);
  PronySeries series;
  layer.at(times_key, [&] {
    if (shares.size() != times.size())
      throw Error(layer.full(times_key) + ": has " + std::to_string(times.size()) + " numbers, " +
                  std::string(shares_key) + " has " + std::to_string(shares.size()));
    for (std::size_t k = 0; k < shares.size(); ++k) series.push_back({shares[k], times[k]});
    check(std::string(shares_key), series);
  });
  return series;
}

Material read_layer_material(const TomlSection& layer) {
  const auto key = layer.one_of({"young_modulus", "shear_modulus", "hardness"});
  const double value = layer.number(key), poisson_ratio = layer.number("poisson_ratio");
  if (key == "shear_modulus") return {value, poisson_ratio};
  return Material::from_young(key == "hardness" ? young_modulus_of_shore_a(value) : value, poisson_ratio);
}

BodyLayer read_body_layer(const TomlSection& layer) {
  layer.allow_described();
  BodyLayer input{.thickness = layer.number("thickness"), .material = {read_layer_material(layer)}};
  input.material.shear_relaxation = read_relaxation(layer, "relaxation_shares", "relaxation_times");
  input.material.bulk_relaxation = read_relaxation(layer, "bulk_relaxation_shares", "bulk_relaxation_times");
  return input;
}

} // namespace

std::vector<BodyLayer> read_body_layers(const TomlSection& body) {
  std::vector<BodyLayer> layers;
  for (const TomlSection& layer : body.sections("layers")) layers.push_back(read_body_layer(layer));
  body.at("layers", [&] { require_count("layers", static_cast<int>(layers.size()), 0, LayeredBody::most_layers); });
  return layers;
}

} // namespace microslip::io
