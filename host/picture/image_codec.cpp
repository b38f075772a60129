#include "host/picture/image_codec.hpp"

#include <dlfcn.h>

#include <filesystem>

namespace halfspace {
namespace {

const ImageCodec* load(std::string& error) {
  // Beside the program, or where it was built.
  std::error_code no_proc;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", no_proc);
  const std::filesystem::path built = HALFSPACE_CODEC_MODULE;
  const auto beside = program.parent_path() / built.filename();
  void* const module =
      dlopen((std::filesystem::exists(beside, no_proc) ? beside : built).c_str(), RTLD_NOW);  // for good
  void* const codec = module == nullptr ? nullptr : dlsym(module, "halfspace_image_codec");
  if (codec == nullptr) {
    error = std::string("the module for pictures cannot be loaded (") + dlerror() + "): build it beside the program";
  }
  return static_cast<const ImageCodec*>(codec);
}

}  // namespace

const ImageCodec* image_codec(std::string& error) {
  static const ImageCodec* codec = nullptr;
  if (codec == nullptr) codec = load(error);
  return codec;
}

}  // namespace halfspace
