#include "platform/gles/program.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "platform/gles/extension.h"

namespace docent::gles {
namespace {

Result<GlShader> compile(GLenum stage, std::string_view name,
                         std::initializer_list<std::string_view> pieces) {
  std::string source = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
  if (can_shaders_encode()) source += "#define ENCODES\n";
  for (const std::string_view piece : pieces) source += piece;
  GlShader shader(glCreateShader(stage));
  const char* text = source.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader.get(), log.size(), nullptr, log.data());
  return std::unexpected(
      Error{Errc::Environment,
            fmt::format("the graphics driver refuses the {} shader '{}': {}",
                        stage == GL_VERTEX_SHADER ? "vertex" : "fragment", name, log.data())});
}

void bind_block(GLuint program, const char* name, Block block) {
  const GLuint index = glGetUniformBlockIndex(program, name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, static_cast<GLuint>(block));
}

void bind_sampler(const Program& program, const char* name, Unit unit) {
  glUniform1i(program[name], static_cast<GLint>(unit));
}

}  // namespace

Result<Program> link_program(std::string_view name, std::initializer_list<std::string_view> vertex,
                             std::initializer_list<std::string_view> fragment) {
  const auto vertex_shader = compile(GL_VERTEX_SHADER, name, vertex);
  if (!vertex_shader) return std::unexpected(vertex_shader.error());
  const auto fragment_shader = compile(GL_FRAGMENT_SHADER, name, fragment);
  if (!fragment_shader) return std::unexpected(fragment_shader.error());

  GlProgram linked(glCreateProgram());
  const GLuint raw = linked.get();
  glAttachShader(raw, vertex_shader->get());
  glAttachShader(raw, fragment_shader->get());
  glLinkProgram(raw);
  GLint status = GL_FALSE;
  glGetProgramiv(raw, GL_LINK_STATUS, &status);
  if (status != GL_TRUE) {
    std::array<char, 1024> log{};
    glGetProgramInfoLog(raw, log.size(), nullptr, log.data());
    return std::unexpected(
        Error{Errc::Environment,
              fmt::format("the graphics driver cannot link '{}': {}", name, log.data())});
  }
  // Attached, a deleted shader would keep its source and its compiled form for the program's life.
  glDetachShader(raw, vertex_shader->get());
  glDetachShader(raw, fragment_shader->get());
  bind_block(raw, "Frame", Block::Frame);
  bind_block(raw, "Avatars", Block::Avatars);
  bind_block(raw, "Looks", Block::Looks);
  Program program(std::move(linked));
  program.use();
  bind_sampler(program, "image", Unit::Image);
  bind_sampler(program, "light_map", Unit::LightMap);
  bind_sampler(program, "shade_map", Unit::ShadeMap);
  bind_sampler(program, "shadow_atlas", Unit::ShadowAtlas);
  bind_sampler(program, "wall_levels", Unit::WallLevels);
  return program;
}

}  // namespace docent::gles
