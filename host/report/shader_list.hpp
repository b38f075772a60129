// shader_list.hpp - the shaders that a report runs, in the order of its rows. A new shader joins by a line here.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/engine.hpp"

namespace halfspace {

struct ListedShader {
  const char* name;
  Shader shader;
  std::int32_t stride;  // of Shader::stride
  bool exact;           // promises every dot
};

inline constexpr std::array listed_shaders{
    ListedShader{"auto", Shader::automatic, 1, true},     ListedShader{"contour", Shader::contour, 1, true},
    ListedShader{"isqrt", Shader::isqrt, 1, true},        ListedShader{"jordan", Shader::jordan, 1, true},
    ListedShader{"stride 4", Shader::stride, 4, false},   ListedShader{"stride 8", Shader::stride, 8, false},
    ListedShader{"stride 16", Shader::stride, 16, false}, ListedShader{"stride 32", Shader::stride, 32, false},
};

// Of pages without bodies, where all do the same, and of the baselines' pictures: any exact one.
inline constexpr const ListedShader& main_shader = listed_shaders[0];

}  // namespace halfspace
