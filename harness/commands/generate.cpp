#include "harness/commands/commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "meshes/generators/generators.h"
#include "meshes/mesh_file.h"

namespace geodesic::harness {
namespace {

struct GenerateArguments {
  std::string name;
  std::string output;
  bool list = false;
};

std::string usage(const GeneratorDescription& generator) {
  std::ostringstream text;
  text << generator.name << "\n  " << generator.description << '\n';
  if (!generator.closed_form.empty()) text << "  distances: " << generator.closed_form << '\n';
  for (const ParameterDescription& parameter : generator.parameters) {
    text << "    --" << std::left << std::setw(14) << parameter.name << ' ' << parameter.description
         << "; "
         << (parameter.is_required()
                 ? "required"
                 : parameter.range() + ", by default " + parameter.default_value.text())
         << '\n';
  }
  return text.str();
}

std::string list_of_generators() {
  std::string text;
  for (const auto& generator : generator_descriptions()) {
    text += (text.empty() ? "" : "\n") + usage(generator);
  }
  return text;
}

// The end of the command's help.
std::string parameters_or_examples(const std::string& name) {
  for (const GeneratorDescription& generator : generator_descriptions()) {
    if (generator.name == name) return '\n' + usage(generator);
  }
  return "\nExamples:\n  geodesic-bench generate icosphere --frequency 20 -o sphere.ply\n"
         "  geodesic-bench generate terrain --help";
}

/// Parses the arguments that CLI11 left over: `--name value` or `--name=value`.
GeneratorParameters parse_parameters(const std::vector<std::string>& words) {
  GeneratorParameters parameters;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].rfind("--", 0) != 0) {
      throw HarnessError("generate: unexpected '" + words[i] +
                         "'; parameters are given as --name value");
    }
    std::string name = words[i].substr(2);
    const std::size_t equals = name.find('=');
    if (equals == std::string::npos && i + 1 == words.size()) {
      throw HarnessError("generate: parameter --" + name + " has no value");
    }
    std::string value = equals == std::string::npos ? words[++i] : name.substr(equals + 1);
    name.resize(std::min(equals, name.size()));
    if (!parameters.emplace(name, std::move(value)).second) {
      throw HarnessError("generate: parameter --" + name + " is given twice");
    }
  }
  return parameters;
}

void generate_file(const GenerateArguments& arguments, const std::vector<std::string>& words) {
  if (arguments.list) {
    if (!arguments.name.empty() || !arguments.output.empty() || !words.empty()) {
      throw HarnessError("generate: --list takes no other argument");
    }
    std::cout << list_of_generators();
    return;
  }
  if (arguments.name.empty() || arguments.output.empty()) {
    throw HarnessError("generate: needs the NAME of a generator and -o FILE, or --list");
  }
  std::vector<std::string> remarks;
  const TriangleSoup soup = generate(arguments.name, parse_parameters(words), &remarks);
  for (const std::string& remark : remarks) {
    std::cerr << arguments.name << ": " << harmless(remark) << '\n';
  }
  write_bytes(arguments.output, mesh_bytes(soup, arguments.output));
}

}  // namespace

void add_generate_command(CLI::App& app) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* const command =
      app.add_subcommand("generate", "Make a mesh: generate NAME [--PARAMETER VALUE ...] -o FILE");
  command->add_option("name", arguments->name, "generator; with --help, its parameters are shown")
      ->type_name("NAME");
  command->add_option("-o,--output", arguments->output, "mesh file to write: .ply, .obj or .off")
      ->type_name("FILE");
  command->add_flag("--list", arguments->list, "print the generators and their parameters");
  command->footer([arguments] { return parameters_or_examples(arguments->name); });
  command->allow_extras();
  command->callback([arguments, command] { generate_file(*arguments, command->remaining()); });
}

}  // namespace geodesic::harness
