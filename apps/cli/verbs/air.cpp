// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/evaluate/correction_text.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/periodic/air_answer.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/standards/readings/test_air.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct AirArguments {
  double celsius = 20.0;
  double kPa = 101.325;
  double percent = 50.0;
  double co2_ppm = 450.0;
  double vacuum_nm = helium_neon_nm;
  std::vector<AirEquation> equations = {AirEquation::ciddor, AirEquation::edlen};
  std::string json;
};

/// An option for one of the arguments, which has its default already.
void add_input(const Verb& verb, const std::string& name, double& target, const std::string& help) {
  add_number(verb, {name, "NUMBER", fmt::format("{} ({})", help, format_exact(target))},
             [&target](double x) { target = x; });
}

std::vector<AirEquation> equations_of(const std::string& word) {
  if (word == "both") return {AirEquation::ciddor, AirEquation::edlen};
  const auto equation = app::parse_air_equation(word);
  if (!equation)
    throw UsageError("--equation", fmt::format("found {}, expected ciddor, edlen or both", text::quoted(word)));
  return {*equation};
}

constexpr std::size_t name_width = 34;
constexpr std::size_t answer_width = 16;

template <typename Shown>
void print_row(std::string_view name, const std::vector<app::AirAnswer>& answers, const Shown& shown) {
  std::string line = left(name, name_width);
  for (const app::AirAnswer& answer : answers) line += right(shown(answer), answer_width);
  fmt::print("{}\n", line);
}

/// "−0.951" for a slope of −0.951e-6 and a scale of 1e6.
std::string scaled(double x, double scale, int decimals) { return format_fixed(x * scale, decimals); }

void print_answers(const AirArguments& arguments, const std::vector<app::AirAnswer>& answers) {
  fmt::print("Air of {} °C, {} kPa, {} % relative humidity, {} ppm CO2; vacuum wavelength {} nm\n\n",
             format_exact(arguments.celsius), format_exact(arguments.kPa), format_exact(arguments.percent),
             format_exact(arguments.co2_ppm), format_exact(arguments.vacuum_nm));
  print_row("", answers, [](const auto& a) { return std::string(air_equation_key(a.equation)); });
  print_row("Refractive index n", answers, [](const auto& a) { return format_fixed(1.0 + a.refractivity, 9); });
  print_row("(n − 1) · 10⁸", answers, [](const auto& a) { return scaled(a.refractivity, 1e8, 1); });
  print_row("Wavelength in air, nm", answers,
            [](const auto& a) { return format_fixed(a.wavelength_in_air.in_nm(), 6); });
  print_row("Water vapour, kPa", answers, [](const auto& a) { return format_fixed(a.water_vapour.in_kPa(), 4); });
  print_row("dn per °C, 10⁻⁶", answers, [](const auto& a) { return scaled(a.sensitivities.per_celsius, 1e6, 4); });
  print_row("dn per Pa, 10⁻⁹", answers, [](const auto& a) { return scaled(a.sensitivities.per_pascal, 1e9, 4); });
  print_row("dn per % humidity, 10⁻⁸", answers,
            [](const auto& a) { return scaled(a.sensitivities.per_percent, 1e8, 4); });
  print_row("dn per ppm CO2, 10⁻¹⁰", answers,
            [](const auto& a) { return scaled(a.sensitivities.per_ppm_co2, 1e10, 4); });
  fmt::print("\n");
  for (const app::AirAnswer& answer : answers)
    fmt::print("{}: {}\n", air_equation_key(answer.equation), air_equation_name(answer.equation));
  if (arguments.kPa < 50.0 || arguments.kPa > 110.0)
    fmt::print("{} kPa is no pressure of the air where people work, which is 50 to 110 kPa.\n",
               format_exact(arguments.kPa));
  fmt::print("The uncertainty of n in a workshop is that of the air's temperature, pressure and humidity.\n");
}

int run_air(const AirArguments& arguments) {
  const Air air{Temperature::celsius(arguments.celsius), Pressure::kPa(arguments.kPa),
                RelativeHumidity::percent(arguments.percent), arguments.co2_ppm};
  const Length wavelength = Length::nm(arguments.vacuum_nm);
  const auto answers = app::answer_air(air, wavelength, arguments.equations);
  if (!answers) return failed(answers.error());
  if (arguments.json != "-") print_answers(arguments, *answers);
  if (arguments.json.empty()) return exit_done;
  const auto written = app::write_file(arguments.json, json::dump(app::air_to_json(air, wavelength, *answers)) + "\n");
  return written ? exit_done : failed(written.error());
}

}  // namespace

void add_air(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("air", "Refractive index of air and the wavelength of a laser in it");
  auto arguments = std::make_shared<AirArguments>();
  add_input(*verb, "--temperature", arguments->celsius, "Air temperature in °C, -40 to 100");
  add_input(*verb, "--pressure", arguments->kPa, "Air pressure in kPa, 10 to 140");
  add_input(*verb, "--humidity", arguments->percent, "Relative humidity in %");
  add_input(*verb, "--co2", arguments->co2_ppm, "Carbon dioxide in ppm by volume, 0 to 2000");
  add_input(*verb, "--wavelength", arguments->vacuum_nm, "Vacuum wavelength in nm, 300 to 1700");
  verb->add_option_function<std::string>(
          "--equation", [arguments](const std::string& word) { arguments->equations = equations_of(word); },
          "ciddor (Ciddor 1996), edlen (Edlén, updated by Birch and Downs 1994) or both (both)")
      ->type_name("NAME");
  verb->add_option("--json", arguments->json, "As JSON to FILE, or to the standard output with -")->type_name("FILE");
  verb->callback([arguments, &exit_code] { exit_code = run_air(*arguments); });
  verb->footer(R"(Examples:
  axiometry air --temperature 23.4 --pressure 98.7 --humidity 40
  axiometry air --pressure 101.325 --humidity 0 --wavelength 633 --equation ciddor --json -)");
}

}  // namespace axiometry::cli
