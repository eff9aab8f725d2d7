# The layering of the tree, read from the includes, so that nobody has to remember it (see STYLE in README "Where to start reading").
# Run as a test: cmake -DROOT=... -P tests/arrows.cmake

set(failures "")

# no_arrow(FOLDER PATTERN [EXCEPT REGEX]): no file below FOLDER includes anything that matches PATTERN.
function(no_arrow folder pattern)
  cmake_parse_arguments(A "" "EXCEPT" "" ${ARGN})
  file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cpp")
  if(NOT files)
    message(FATAL_ERROR "arrows: there is no source in ${folder}")
  endif()
  foreach(file ${files})
    if(A_EXCEPT AND file MATCHES "${A_EXCEPT}")
      continue()
    endif()
    file(STRINGS "${ROOT}/${file}" lines REGEX "^#include [<\"](${pattern})")
    foreach(line ${lines})
      string(APPEND failures "${file}: ${line}\n")
    endforeach()
  endforeach()
  set(failures "${failures}" PARENT_SCOPE)
endfunction()

set(guide_parts "path|company|motion|plan|input|scene|guide|kiosk")

# The vocabulary uses nothing but the standard library and GLM.
no_arrow(runtime/model "runtime/(${guide_parts})/|platform/|content/|config/|fmt/|sqlite3|nlohmann/|toml")
# The guide's parts know the model and each other only as the arrows allow, and no edge of the world.
foreach(part path motion input)
  string(REGEX REPLACE "(^|\\|)${part}(\\||$)" "\\1nothing\\2" others "${guide_parts}")
  no_arrow(runtime/${part} "runtime/(${others})/")
endforeach()
no_arrow(runtime/company "runtime/(motion|plan|input|scene|guide|kiosk)/")
no_arrow(runtime/scene "runtime/(plan|guide|kiosk)/")
no_arrow(runtime/plan "runtime/(guide|kiosk)/")
no_arrow(runtime/guide "runtime/kiosk/")
no_arrow(runtime "platform/|config/|EGL/|GLES|sqlite3|hidapi|pango|xcb/|xf86drm" EXCEPT "runtime/kiosk/")
# Edges know the model and the scene, and never the guide.
no_arrow(platform "runtime/(plan|guide|kiosk)/")
# The product does not know its tools, and the kiosk carries no geometry library.
foreach(folder runtime platform config)
  no_arrow(${folder} "content/|CGAL/|boost/|gmp|mpfr|librsvg|tiny_gltf")
endforeach()
no_arrow(config "platform/(clock|egl|gles|headless|hid|kms|pango|png|sqlite|x11)/|runtime/(${guide_parts})/")
# CGAL is a private matter of the files that build diagrams and triangulations.
no_arrow(content "CGAL/" EXCEPT "content/(floor|light)/[a-z_]+\\.cpp$")
no_arrow(content "runtime/(plan|guide|kiosk|scene)/")

if(failures)
  message(FATAL_ERROR "includes against the arrows:\n${failures}")
endif()
message(STATUS "the arrows hold")
