#include "host/picture/image_codec.hpp"

#include <dlfcn.h>

namespace halfspace {
namespace {

const ImageCodec* load(std::string& error) {
  void* const module = dlopen(HALFSPACE_CODEC_MODULE, RTLD_NOW);  // for good
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
