#include "harness/commands/export.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/exports/exports.h"

namespace geodesic::harness {
namespace {

struct ExportFlags {
  std::string format, file;
};

void run_export(const ExportFlags& flags) {
  check_export_format(flags.format);  // before a file is read
  const ResultFile result = read_result_file(flags.file);
  std::cout << export_as(flags.format, result);
  const auto failed = std::count_if(result.cells.begin(), result.cells.end(),
                                    [](const CellResult& cell) { return !cell.ok(); });
  if (failed > 0) {
    std::cerr << "geodesic-bench: " << failed << " of " << result.cells.size()
              << " cells failed and have no numbers\n";
  }
}

}  // namespace

void add_export_command(CLI::App& app) {
  const auto flags = std::make_shared<ExportFlags>();
  CLI::App* command = app.add_subcommand("export", "A run in the format of another tool");
  command->add_option("--to", flags->format, join(export_formats()))
      ->required()
      ->type_name("FORMAT");
  command->add_option("result", flags->file, "a result file or run folder")->required();
  command->callback([flags] { run_export(*flags); });
}

}  // namespace geodesic::harness
