// halfspace - the command line (design: a contract, see README and `halfspace --help`).
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>

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

void add_page_options(CLI::App& command, PageRequest& page) {
  command.add_option("-d,--device", page.device, "varian, versatec, gray, ascii, braille, ssd1306 or pwg")
      ->capture_default_str();
  command.add_option("--size", page.size, "Page in dots, as in 640x480; by default the device's own");
  command.add_option("--dpi", page.dpi, "Recorded density; never changes the geometry")->check(CLI::Range(1, 100000));
  command.add_option("--levels", page.levels, "Levels from black to white")->check(CLI::Range(2, 256));
  command.add_option("--background", page.background, "Dots that show nothing")
      ->check(CLI::IsMember({"black", "white"}));
  command.add_option("--screen", page.screen, "Halftone screen of bilevel devices")
      ->check(CLI::IsMember({"clustered", "bayer", "blue-noise"}))
      ->capture_default_str();
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

  RenderRequest render;
  CLI::App* render_command = app.add_subcommand("render", "Draw scene files on a device");
  add_scene_options(*render_command, render.scene);
  add_page_options(*render_command, render.page);
  render_command->add_option(
      "-o,--output", render.output,
      "A picture (.png .tif .pbm .pgm .exr), the device's bytes (.prn), or - for standard output");
  CLI::Option* shader =
      render_command
          ->add_option("--shader", render.shader,
                       "How curved faces are shaded: isqrt and jordan exactly, stride by averages between some dots")
          ->check(CLI::IsMember({"isqrt", "jordan", "stride"}))
          ->capture_default_str();
  render_command
      ->add_option("--stride", render.stride, "Of the shader stride: levels at most so many dots apart; 1 is exact")
      ->check(CLI::Range(1, 32767))
      ->needs(shader)
      ->capture_default_str();
  render_command->add_flag("--stats", render.statistics, "Print what the picture took");
  render_command->add_option("--stats-json", render.statistics_file,
                             "Write the same figures to a file; the picture stays where this fails");

  InfoRequest info;
  CLI::App* info_command = app.add_subcommand("info", "Say what a scene holds and what drawing it needs");
  add_scene_options(*info_command, info.scene);
  add_page_options(*info_command, info.page);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error);
    return status == 0 ? 0 : static_cast<int>(ExitStatus::command_line_wrong);
  }
  if (*render_command) return static_cast<int>(run_render(render));
  if (*info_command) return static_cast<int>(run_info(info));
  return static_cast<int>(
      fail(ExitStatus::command_line_wrong, "no command; say render or info (see halfspace --help)"));
}

}  // namespace
}  // namespace halfspace

int main(int argc, char** argv) {
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
