// halfspace - the command line (design: a contract, see README and `halfspace --help`).
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>

#include "host/algebra/integer_memory.hpp"
#include "host/cli/commands.hpp"

namespace halfspace {
namespace {

void add_scene_options(CLI::App& command, SceneRequest& scene) {
  command.add_option("scene", scene.paths, "Scene files (.uq; - is standard input); several make one scene")
      ->required();
  command.add_option("--view", scene.view, "The view to draw; by default the last one defined");
  command.add_option("--language", scene.language, "Language of the scene files, whatever their ending")
      ->check(CLI::IsMember({"uq"}));
  command.add_flag("--quiet", scene.quiet, "No warnings and no progress");
}

void add_device_options(CLI::App& command, std::string& device, std::int32_t& dpi) {
  command.add_option("-d,--device", device, "varian, versatec, gray, ascii, braille, ssd1306 or pwg")
      ->capture_default_str();
  command.add_option("--dpi", dpi, "Density that a picture records; never changes the geometry, nor a job")
      ->check(CLI::Range(1, 100000));
}

void add_page_options(CLI::App& command, PageRequest& page) {
  add_device_options(command, page.device, page.dpi);
  command.add_option("--size", page.size, "Page in dots, as in 640x480; by default the device's own");
  command.add_option("--levels", page.levels, "Levels from black to white")->check(CLI::Range(2, 256));
  command.add_option("--background", page.background, "Dots that show nothing")
      ->check(CLI::IsMember({"black", "white"}));
  command.add_option("--screen", page.screen, "Halftone screen of bilevel devices")
      ->check(CLI::IsMember({"clustered", "bayer", "blue-noise"}))
      ->default_str("clustered");
}

void add_picture_options(CLI::App& command, PictureRequest& picture) {
  command.add_option("-o,--output", picture.output,
                     "A picture (.png .tif .pbm .pgm .exr), the device's bytes (.prn), or - for standard output");
  CLI::Option* shader =
      command
          .add_option(
              "--shader", picture.shader,
              "How curved faces are shaded: contour, jordan and isqrt exactly and alike, auto by the cheaper of\n"
              "contour and isqrt, stride by averages between some dots")
          ->check(CLI::IsMember({"auto", "contour", "jordan", "isqrt", "stride"}))
          ->capture_default_str();
  const CLI::Option* stride =
      command
          .add_option("--stride", picture.stride, "Of the shader stride: levels at most so many dots apart; 1 is exact")
          ->check(CLI::Range(1, 32767))
          ->needs(shader)
          ->capture_default_str();
  command.callback([stride, &picture] {
    if (stride->empty() || picture.shader == "stride") return;
    throw CLI::ValidationError("--stride", "the shader " + picture.shader + " takes no stride; say --shader stride");
  });
  command.add_flag("--stats", picture.statistics.table, "Print what the picture took");
  command.add_option("--stats-json", picture.statistics.file,
                     "Write the same figures to a file; the picture stays where this fails");
}

struct Requests {
  RenderRequest render;
  CompileRequest compile;
  RunRequest run;
  InfoRequest info;
  ReportRequest report;
};

struct Commands {
  CLI::App *render, *compile, *run, *info, *report;
};

Commands add_commands(CLI::App& app, Requests& requests) {
  CLI::App* render = app.add_subcommand("render", "Draw scene files on a device");
  add_scene_options(*render, requests.render.scene);
  add_page_options(*render, requests.render.page);
  add_picture_options(*render, requests.render.draw);

  CLI::App* compile = app.add_subcommand("compile", "Make the job that draws scene files on a device");
  add_scene_options(*compile, requests.compile.scene);
  add_page_options(*compile, requests.compile.page);
  compile->add_option("-o,--output", requests.compile.output,
                      "The job to write, by custom .hsj, or - for standard output");

  CLI::App* run = app.add_subcommand("run", "Draw a job that compile has made");
  run->add_option("job", requests.run.path, "The job (- is standard input)")->required();
  add_device_options(*run, requests.run.device, requests.run.dpi);
  add_picture_options(*run, requests.run.draw);
  run->add_flag("--quiet", requests.run.quiet, "No progress");

  CLI::App* info = app.add_subcommand("info", "Say what a scene or a job holds and what drawing it needs");
  add_scene_options(*info, requests.info.scene);
  info->get_option("scene")->description("Scene files, as for render; or one job (.hsj), which has its own page");
  add_page_options(*info, requests.info.page);
  info->callback([info, &said = requests.info.page_option] {
    for (const char* option : {"--view", "--device", "--size", "--dpi", "--levels", "--background", "--screen"}) {
      if (said.empty() && info->count(option) > 0) said = option;
    }
  });

  CLI::App* report = app.add_subcommand("report", "Measure speed against error, and write tables and plots");
  report->add_option("-o,--output", requests.report.folder, "The folder to write into")->capture_default_str();
  report->add_flag("--quick", requests.report.quick, "Few and small scenes, in seconds: to see that all of it works");
  report->add_option("--probe", requests.report.probe)->group("");  // the report itself says it
  return {render, compile, run, info, report};
}

int run(int argc, char** argv) {
  CLI::App app("Halfspace draws curved solids exactly, with integers alone, on devices that know only black and white.",
               "halfspace");
  app.require_subcommand(0, 1);  // none at all is told below, after words that are no command
  app.footer(
      "Exit status: 0 drawn; 1 the scene is wrong; 2 the command line is wrong; 3 a device or file failed;\n"
      "4 a stated limit is exceeded.");
  app.set_version_flag("--version", "halfspace 0.1.0");
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("error: {}; see halfspace --help\n", error.what());
  });
  Requests requests;
  const Commands commands = add_commands(app, requests);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error);
    return status == 0 ? 0 : static_cast<int>(ExitStatus::command_line_wrong);
  }
  if (*commands.render) return static_cast<int>(run_render(requests.render));
  if (*commands.compile) return static_cast<int>(run_compile(requests.compile));
  if (*commands.run) return static_cast<int>(run_job(requests.run));
  if (*commands.info) return static_cast<int>(run_info(requests.info));
  if (*commands.report) return static_cast<int>(run_report(requests.report));
  return static_cast<int>(fail(ExitStatus::command_line_wrong,
                               "no command; say render, compile, run, info or report (see halfspace --help)"));
}

}  // namespace
}  // namespace halfspace

int main(int argc, char** argv) {
  halfspace::keep_memory();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that went away is an error of write, told like any other
  try {
    return halfspace::run(argc, argv);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: out of memory; draw fewer bodies at once\n");
    return static_cast<int>(halfspace::ExitStatus::limit_exceeded);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return static_cast<int>(halfspace::ExitStatus::device_or_file_failed);
  }
}
