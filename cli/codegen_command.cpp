// SPDX-License-Identifier: MIT
// hodograph codegen: one path as C99 source text.
#include "cli/commands.hpp"
#include "cli/left_out.hpp"
#include "hodograph/foundation/result.hpp"

#ifdef HODOGRAPH_HAS_CONTROL
#include <filesystem>
#include <memory>

#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "hodograph/control/code_generation.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_CONTROL
namespace {

struct CodegenFlags {
  std::string document, directory = ".";
  CodeOptions options;
};

void run(const CodegenFlags& flags) {
  const PathDocument document = load_document(flags.document).value();
  const GeneratedCode code = generate_code(document.path, flags.options).value();
  const auto place = [&](const std::string& name) {
    return flags.directory == "." ? name : (std::filesystem::path(flags.directory) / name).string();
  };
  const std::string header = place(code.header_name), source = place(code.source_name);
  OutputFile header_file = OutputFile::create(header).value();
  OutputFile source_file = OutputFile::create(source).value();
  header_file.write(code.header);
  source_file.write(code.source);
  if (const auto fault = header_file.commit()) throw Error(*fault);
  if (const auto fault = source_file.commit()) throw Error(*fault);
  print("wrote " + header + "\nwrote " + source + "\n");
}

}  // namespace

std::unique_ptr<Command> codegen_command(CLI::App& program) {
  auto flags = std::make_shared<CodegenFlags>();
  auto command = std::make_unique<Command>(
      program, "codegen", "A path as C functions, for programs and solvers without this library.");
  add_document_to(*command, flags->document);
  command->group("Code");
  command->option("--name", flags->options.name, "NAME",
                  "what the files and all functions are called (default path)");
  command->flag("--casadi", flags->options.casadi,
                "also the external functions NAME, jac_NAME and jac_jac_NAME for CasADi");
  command->option("-o,--out", flags->directory, "DIRECTORY",
                  "where NAME.h and NAME.c go (default: here)");
  command->examples({"hodograph codegen track.json --name track",
                     "hodograph codegen gateway.json --name gateway --casadi && cc -O2 -shared "
                     "-fPIC gateway.c -o gateway.so -lm"});
  command->note(
      "C99 without allocation: position, arc length, speed, frame, rates and curvature with their\n"
      "derivatives, equal to the library's bit for bit. A parameter outside the knots is an error\n"
      "code. In CasADi: gateway = external('gateway', './gateway.so'). See docs/control.md.");
  command->run([flags] { run(*flags); });
  return command;
}

#else

std::unique_ptr<Command> codegen_command(CLI::App& program) {
  return command_left_out(program, "codegen", "Ipopt");
}

#endif

}  // namespace hodograph::cli
