#include "content/import/gltf/accessor.h"
#include "content/import/gltf/scene.h"

namespace docent::import::gltf {
namespace {

/// Calls `check` for each entry of a list; what it throws becomes a warning.
template <typename Check>
void each_of(Source& source, const char* list, Check check) {
  constexpr std::size_t most_looked_at = 2000;
  try {
    const Part parts = source.root()[list];
    for (std::size_t i = 0; i < std::min(parts.size(), most_looked_at); ++i) {
      try {
        check(parts.at(i));
      } catch (const content::ContentError& error) {
        source.warn(error.what());
      }
    }
  } catch (const content::ContentError& error) {
    source.warn(error.what());
  }
}

void check_bounds(const Part& view, const Part& buffers) {
  const auto buffer =
      static_cast<std::size_t>(std::max(view["buffer"].index_or_none(buffers.size(), "buffer"), 0));
  const std::uint64_t most = buffers.at(buffer)["byteLength"].whole(1, UINT32_MAX);
  const std::uint64_t end =
      view["byteOffset"].whole_or(0, UINT32_MAX) + view["byteLength"].whole(1, UINT32_MAX);
  const Part extensions = view["extensions"];
  const bool is_packed = extensions.is_there() && extensions["EXT_meshopt_compression"].is_there();
  if (!is_packed && end > most)
    view.fail(fmt::format("reaches to byte {}, beyond the {} of its buffer", end, most));
}

}  // namespace

void look_over(Source& source) {
  const Part root = source.root();
  const auto count = [&](const char* list) {
    try {
      return root[list].size();
    } catch (const content::ContentError&) {
      return std::size_t{0};  // told when its turn comes
    }
  };
  each_of(source, "buffers", [&](const Part& part) {
    part["byteLength"].whole(1, UINT32_MAX);
    part["uri"].text_or("");
  });
  each_of(source, "bufferViews", [&](const Part& part) { check_bounds(part, root["buffers"]); });
  each_of(source, "accessors", [&](const Part& part) {
    part["componentType"].whole(5120, 5126);
    part["count"].whole(1, UINT32_MAX);
    part["type"].text();
    part["bufferView"].index_or_none(count("bufferViews"), "bufferView");
  });
  each_of(source, "images", [&](const Part& part) {
    if (part["uri"].is_there() == part["bufferView"].is_there())
      part.fail("must have either a uri or a bufferView");
    part["bufferView"].index_or_none(count("bufferViews"), "bufferView");
  });
  each_of(source, "textures", [&](const Part& part) {
    part["source"].index_or_none(count("images"), "image");
    part["sampler"].index_or_none(count("samplers"), "sampler");
  });
  each_of(source, "materials", [&](const Part& part) {
    for (const char* name : {"normalTexture", "occlusionTexture", "emissiveTexture"})
      if (const Part texture = part[name]; texture.is_there())
        texture["index"].index_or_none(count("textures"), "texture");
  });
  each_of(source, "skins",
          [&](const Part& part) { part["skeleton"].index_or_none(count("nodes"), "node"); });
  each_of(source, "nodes",
          [&](const Part& part) { part["camera"].index_or_none(count("cameras"), "camera"); });
  each_of(source, "meshes", [&](const Part& part) {
    const Part primitives = part["primitives"];
    if (primitives.size() == 0) primitives.fail("is empty");
    for (std::size_t i = 0; i < std::min<std::size_t>(primitives.size(), 100); ++i) {
      const Part one = primitives.at(i);
      one["indices"].index_or_none(count("accessors"), "accessor");
      one["material"].index_or_none(count("materials"), "material");
      for (const std::string& name : one["attributes"].keys())
        one["attributes"][name].index_or_none(count("accessors"), "accessor");
    }
  });
  each_of(source, "animations", [&](const Part& part) {
    const Part samplers = part["samplers"], channels = part["channels"];
    for (std::size_t i = 0; i < std::min<std::size_t>(samplers.size(), 1000); ++i)
      for (const char* name : {"input", "output"})
        if (samplers.at(i)[name].index_or_none(count("accessors"), "accessor") < 0)
          samplers.at(i)[name].fail("is missing");
    for (std::size_t i = 0; i < std::min<std::size_t>(channels.size(), 1000); ++i) {
      channels.at(i)["sampler"].index_or_none(samplers.size(), "sampler");
      channels.at(i)["target"]["node"].index_or_none(count("nodes"), "node");
    }
  });
}

}  // namespace docent::import::gltf
